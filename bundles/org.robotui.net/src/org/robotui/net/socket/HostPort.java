package org.robotui.net.socket;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.UnknownHostException;
import java.time.Duration;

/**
 * A host and a port. Host names may hold underscores, which {@link java.net.URI} refuses.
 *
 * @param host a name or an address, IPv6 without brackets; 1 to 255 characters
 * @param port 1 to 65535
 */
public record HostPort(String host, int port) {

  /** Refuses what can be no host and port with an {@link IllegalArgumentException}. */
  public HostPort {
    if (host.isBlank() || host.length() > 255 || port < 1 || port > 65535) {
      throw new IllegalArgumentException("'" + host + ":" + port + "' is no host and port");
    }
  }

  /**
   * Parses {@code scheme://host:port/...}.
   *
   * @param uri what to parse; what follows the port is ignored
   * @param scheme the scheme that it must have
   * @return its host and port
   * @throws IllegalArgumentException if it has another scheme or no host and port
   */
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

  /**
   * Parses {@code HOST}, {@code HOST:PORT} or {@code :PORT}, as variables of the environment say where a server is.
   *
   * @param variable the name of the variable, for who reads the error
   * @param written what it holds; nothing before the colon is this machine
   * @param usual the port where none is written
   * @return the host and port
   * @throws IllegalArgumentException where it holds something else; names the variable, and says what to write
   */
  public static HostPort ofVariable(String variable, String written, int usual) {
    int colon = written.lastIndexOf(':');
    String host = colon < 0 ? written : written.substring(0, colon);
    try {
      return new HostPort(host.isEmpty() ? "localhost" : host,
          colon < 0 ? usual : Integer.parseInt(written.substring(colon + 1)));
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(variable + " is '" + written + "'; write HOST or HOST:PORT", e);
    }
  }

  /**
   * Looks the host up, which blocks while a name server is asked.
   *
   * @return the address
   * @throws UnknownHostException if the name cannot be resolved; says which
   */
  public InetSocketAddress resolve() throws UnknownHostException {
    InetSocketAddress address = new InetSocketAddress(host, port);
    if (address.isUnresolved()) {
      throw new UnknownHostException("host name '" + host + "' cannot be resolved");
    }
    return address;
  }

  /**
   * Connects a socket, which blocks.
   *
   * @param socket not connected yet
   * @param timeout at most so long, beside the time that a name server takes
   * @throws IOException if the host is unknown or cannot be reached; names it
   */
  public void connect(Socket socket, Duration timeout) throws IOException {
    InetSocketAddress address = resolve();
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
