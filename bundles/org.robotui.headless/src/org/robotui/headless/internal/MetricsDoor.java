package org.robotui.headless.internal;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.function.Supplier;

/** Gives numbers to those who ask by HTTP on this machine. */
final class MetricsDoor implements AutoCloseable {
  private static final String PATH = "/metrics";
  private static final int FOUND = 200;
  private static final int NOT_FOUND = 404;
  private static final int WAITING = 8;

  private final HttpServer server;

  private MetricsDoor(HttpServer server) {
    this.server = server;
  }

  /**
   * Opens it on the loopback interface alone.
   *
   * @param port 0 for any free one
   */
  static MetricsDoor open(int port, Supplier<String> numbers) throws IOException {
    HttpServer server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), WAITING);
    server.createContext("/", exchange -> answer(exchange, numbers));
    server.start();
    return new MetricsDoor(server);
  }

  String address() {
    return "http://" + InetAddress.getLoopbackAddress().getHostAddress() + ":" + server.getAddress().getPort() + PATH;
  }

  private static void answer(HttpExchange exchange, Supplier<String> numbers) throws IOException {
    try (exchange) {
      boolean known = exchange.getRequestURI().getPath().equals(PATH);
      byte[] body = (known ? numbers.get() : "the numbers are at " + PATH + "\n").getBytes(StandardCharsets.UTF_8);
      exchange.getResponseHeaders().set("Content-Type", "text/plain; version=0.0.4; charset=utf-8");
      exchange.sendResponseHeaders(known ? FOUND : NOT_FOUND, body.length);
      exchange.getResponseBody().write(body);
    }
  }

  @Override
  public void close() {
    server.stop(0);
  }
}
