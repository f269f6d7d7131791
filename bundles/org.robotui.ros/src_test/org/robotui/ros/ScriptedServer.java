package org.robotui.ros;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robotui.net.thread.Workers;

/** Accepts connections and does to each what a test wants, on a thread of its own. */
final class ScriptedServer implements AutoCloseable {

  /** What happens to one connection. */
  interface Script {

    void run(InputStream in, OutputStream out) throws IOException;
  }

  private static final Pattern LENGTH = Pattern.compile("Content-Length: (\\d+)");

  private final ServerSocket server = new ServerSocket(0, 50, InetAddress.getByName("127.0.0.1"));
  private final Set<Socket> sockets = ConcurrentHashMap.newKeySet();
  private final AtomicInteger connections = new AtomicInteger();

  ScriptedServer(Graph graph, Script script) throws IOException {
    Workers workers = new Workers(graph.threads());
    workers.start("scripted", () -> accept(workers, script));
  }

  private void accept(Workers workers, Script script) {
    while (!server.isClosed()) {
      try {
        Socket socket = server.accept();
        sockets.add(socket);
        connections.incrementAndGet();
        workers.start("scripted connection", () -> serve(socket, script));
      } catch (IOException e) {
        // closed
      }
    }
  }

  private void serve(Socket socket, Script script) {
    try (socket) {
      script.run(socket.getInputStream(), socket.getOutputStream());
    } catch (IOException e) {
      // the victim closed, as it should
    } finally {
      sockets.remove(socket);
    }
  }

  int port() {
    return server.getLocalPort();
  }

  int connections() {
    return connections.get();
  }

  String uri(String scheme) {
    return scheme + "://127.0.0.1:" + port() + "/";
  }

  /** Reads a request and then gives this answer. */
  static Script answers(String answer) {
    return (in, out) -> {
      awaitRequest(in);
      out.write(answer.getBytes(StandardCharsets.ISO_8859_1));
    };
  }

  /** All of it: closing with bytes unread would take the answer back. */
  private static void awaitRequest(InputStream in) throws IOException {
    StringBuilder head = new StringBuilder();
    while (head.indexOf("\r\n\r\n") < 0) {
      int next = in.read();
      if (next < 0) {
        throw new IOException("closed");
      }
      head.append((char) next);
    }
    Matcher length = LENGTH.matcher(head);
    in.readNBytes(length.find() ? Integer.parseInt(length.group(1)) : 0);
  }

  /** An HTTP answer with a length that is true. */
  static String http(String body) {
    return "HTTP/1.1 200 OK\r\nContent-Length: " + body.getBytes(StandardCharsets.UTF_8).length + "\r\n\r\n" + body;
  }

  /** Says nothing until the peer gives up. */
  static Script silence() {
    return (in, out) -> in.transferTo(OutputStream.nullOutputStream());
  }

  /** Sends this, and then one more byte again and again with pauses, for ever. */
  static Script drips(String start, String drop) {
    return (in, out) -> {
      out.write(start.getBytes(StandardCharsets.ISO_8859_1));
      while (true) {
        out.write(drop.getBytes(StandardCharsets.ISO_8859_1));
        out.flush();
        java.util.concurrent.locks.LockSupport.parkNanos(20_000_000);
      }
    };
  }

  /** Sends this again and again as fast as it goes. */
  static Script floods(String start, String more) {
    return (in, out) -> {
      out.write(start.getBytes(StandardCharsets.ISO_8859_1));
      byte[] bytes = more.repeat(1000).getBytes(StandardCharsets.ISO_8859_1);
      while (true) {
        out.write(bytes);
      }
    };
  }

  @Override
  public void close() throws IOException {
    server.close();
    for (Socket socket : sockets) {
      socket.close();
    }
  }
}
