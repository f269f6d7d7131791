package org.robotui.ros;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.message.MessageWriter;
import org.robotui.net.socket.HostPort;
import org.robotui.net.thread.Workers;
import org.robotui.ros.internal.tcpros.ConnectionHeader;
import org.robotui.ros.internal.xmlrpc.ApiMethods;
import org.robotui.ros.internal.xmlrpc.XmlRpcClient;
import org.robotui.ros.internal.xmlrpc.XmlRpcLimits;
import org.robotui.ros.internal.xmlrpc.XmlRpcServer;

/** A publisher of /chatter that is registered like any other and then sends whatever bytes a test wants. */
final class FakePublisher implements AutoCloseable {

  /** What is done with each connection of a subscriber, after its header was read. */
  interface Script {

    void run(OutputStream out) throws IOException;
  }

  private final ServerSocket server = new ServerSocket(0, 10, InetAddress.getByName("127.0.0.1"));
  private final XmlRpcServer slave;
  private final AtomicInteger connections = new AtomicInteger();

  FakePublisher(Graph graph, String name, Script script) throws Exception {
    Workers workers = new Workers(graph.threads());
    slave = new XmlRpcServer(InetAddress.getByName("127.0.0.1"), 0, XmlRpcLimits.standard(), workers, name);
    XmlRpcValue endpoint =
        XmlRpcValue.of(XmlRpcValue.of("TCPROS"), XmlRpcValue.of("127.0.0.1"), XmlRpcValue.of(server.getLocalPort()));
    slave.start(new ApiMethods().add("requestTopic", call -> ApiMethods.success("", endpoint), XmlRpcValue.Text.class,
        XmlRpcValue.Array.class));
    workers.start(name, () -> accept(script));
    register(graph, name);
  }

  private void register(Graph graph, String name) throws Exception {
    HostPort master = HostPort.ofUri(graph.master().uri().toString(), "http");
    try (XmlRpcClient client = new XmlRpcClient(master, XmlRpcLimits.standard().withMessage(Duration.ofSeconds(5)))) {
      client.call("registerPublisher",
          List.of(XmlRpcValue.of(name), XmlRpcValue.of("/chatter"), XmlRpcValue.of("std_msgs/String"),
              XmlRpcValue.of("http://127.0.0.1:" + slave.port() + "/")));
    }
  }

  private void accept(Script script) {
    while (!server.isClosed()) {
      try (Socket socket = server.accept()) {
        connections.incrementAndGet();
        readHeader(socket.getInputStream());
        script.run(socket.getOutputStream());
      } catch (IOException e) {
        // the subscriber went away, which is what these tests are about
      }
    }
  }

  private static void readHeader(InputStream in) throws IOException {
    byte[] length = in.readNBytes(4);
    in.readNBytes(length[0] & 0xff | (length[1] & 0xff) << 8);
  }

  int connections() {
    return connections.get();
  }

  static byte[] goodHeader() {
    return ConnectionHeader.of("/liar").with(new TextCodec().info()).with("latching", "0").encode();
  }

  static byte[] message(String text) {
    return new MessageWriter().i32(text.length() + 4).string(text).toByteArray();
  }

  @Override
  public void close() throws IOException {
    server.close();
    slave.close();
  }
}
