# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python package for pip: builds the program and the package by CMake."""

from skbuild import setup

setup(
    name="endmill",
    version="0.1.0",
    description="Computational geometry of sculptured-surface machining",
    license="GPL-3.0-or-later",
    python_requires=">=3.11",
    install_requires=["numpy"],
    packages=["endmill"],
    package_dir={"": "src/python"},
    package_data={"endmill": ["py.typed", "*.pyi"]},
    cmake_args=[
        "-DENDMILL_BUILD_TESTS=OFF", "-DENDMILL_BUILD_EXPERIMENTS=OFF",
        "-DENDMILL_PYTHON_FOLDER=src/python"
    ],
)
