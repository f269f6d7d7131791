package org.robotui.guard;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** A robot's software that serves whoever comes. */
final class Robot implements AutoCloseable {
  private final ServerSocket server = new ServerSocket(0, 200, InetAddress.getLoopbackAddress());
  private final List<Socket> all = new CopyOnWriteArrayList<>();
  private final BlockingQueue<Socket> came = new LinkedBlockingQueue<>();

  Robot() throws IOException {
    Thread thread = new Thread(this::accept);
    thread.setDaemon(true);
    thread.start();
  }

  private void accept() {
    try {
      while (true) {
        Socket socket = server.accept();
        all.add(socket);
        came.add(socket);
      }
    } catch (IOException e) {
      // closed
    }
  }

  InetSocketAddress address() {
    return new InetSocketAddress(server.getInetAddress(), server.getLocalPort());
  }

  Socket next() throws InterruptedException {
    return next(10);
  }

  Socket next(int seconds) throws InterruptedException {
    Socket socket = came.poll(seconds, TimeUnit.SECONDS);
    if (socket == null) {
      throw new AssertionError("nobody came");
    }
    return socket;
  }

  boolean isVisited() {
    return !came.isEmpty();
  }

  /** The next visitor's words, who is answered as an HTTP server would. */
  String hear() throws IOException, InterruptedException {
    try (Socket socket = next()) {
      socket.setSoTimeout(5000);
      byte[] words = new byte[1000];
      int count = socket.getInputStream().read(words);
      socket.getOutputStream().write("HTTP/1.1 200 OK\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
      return new String(words, 0, count, StandardCharsets.UTF_8);
    }
  }

  /** What a robot that writes synchronously endures. */
  record Endured(double longestSeconds, boolean ended) {}

  /** Writes cycle by cycle until the connection ends or the time is over. */
  static Endured drive(Socket socket, int bytes, long periodMillis, long seconds) throws InterruptedException {
    byte[] message = new byte[bytes];
    long longest = 0;
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
    try {
      OutputStream out = socket.getOutputStream();
      while (System.nanoTime() < end) {
        long before = System.nanoTime();
        out.write(message);
        longest = Math.max(longest, System.nanoTime() - before);
        Thread.sleep(periodMillis);
      }
    } catch (IOException e) {
      return new Endured(longest / 1e9, true);
    }
    return new Endured(longest / 1e9, false);
  }

  @Override
  public void close() throws IOException {
    server.close();
    for (Socket socket : all) {
      socket.close();
    }
  }
}
