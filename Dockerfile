# The program and the Python package on Debian 12:
#   docker build -t roomgraph .
#   docker run --rm -u "$(id -u):$(id -g)" -v "$PWD:/maps" roomgraph compare run1.simplemap run2.simplemap -o results
FROM debian:12 AS build
WORKDIR /src
COPY . .
RUN scripts/package

FROM debian:12
COPY --from=build /src/out/packages/roomgraph_*.deb /src/out/packages/python3-roomgraph_*.deb /packages/
RUN apt-get -q update \
 && apt-get -q -y --no-install-recommends install /packages/*.deb \
 && rm -rf /packages /var/lib/apt/lists/*
WORKDIR /maps
ENTRYPOINT ["roomgraph"]
