# SPDX-License-Identifier: GPL-3.0-or-later
# Debian 12 with everything that building, testing and reproducing need, and the program built.
#
#   docker build --tag endmill .
#   docker run --rm endmill endmill plan datasets/surfaces/saddle.json --output /tmp/saddle
#   docker run --rm --volume "$PWD/results:/endmill/results" endmill scripts/reproduce.sh
FROM debian:12
WORKDIR /endmill
# Packages first: they change less often than the sources.
COPY scripts/setup.sh scripts/packages.txt scripts/
RUN scripts/setup.sh && rm -rf /var/lib/apt/lists/*
COPY . .
RUN cmake --preset release && cmake --build --preset release && cmake --install build/release
CMD ["endmill", "--help"]
