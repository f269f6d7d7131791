package org.robotui.ros.internal.io;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.UnknownHostException;
import java.time.Duration;

/** A host and a port, as they stand in ROS URIs. Host names may hold underscores, which {@link java.net.URI} refuses. */
public record HostPort(String host, int port) {

  public HostPort {
    if (host.isBlank() || host.length() > 255 || port < 1 || port > 65535) {
      throw new IllegalArgumentException("'" + host + ":" + port + "' is no host and port");
    }
  }

  /** Parses {@code scheme://host:port/...}. */
  public static HostPort ofUri(String uri, String scheme) {
    String prefix = scheme + "://";
    if (!uri.startsWith(prefix)) {
      throw new IllegalArgumentException("'" + uri + "' is no " + prefix + "host:port URI");
    }
    String authority = uri.substring(prefix.length()).replaceFirst("/.*", "");
    int colon = authority.lastIndexOf(':');
    if (colon < 1 || !authority.substring(colon + 1).matches("\\d{1,5}")) {
      throw new IllegalArgumentException("'" + uri + "' names no host and port");
    }
    String host = authority.substring(0, colon).replaceAll("[\\[\\]]", "");
    return new HostPort(host, Integer.parseInt(authority.substring(colon + 1)));
  }

  /** Connects the socket; the error names the address. */
  public void connect(Socket socket, Duration timeout) throws IOException {
    InetSocketAddress address = new InetSocketAddress(host, port);
    if (address.isUnresolved()) {
      throw new UnknownHostException("host name '" + host + "' cannot be resolved");
    }
    try {
      socket.connect(address, (int) Math.max(1, timeout.toMillis()));
    } catch (IOException e) {
      throw new IOException("cannot connect to " + this + ": " + e.getMessage(), e);
    }
  }

  @Override
  public String toString() {
    return (host.contains(":") ? "[" + host + "]" : host) + ":" + port;
  }
}
