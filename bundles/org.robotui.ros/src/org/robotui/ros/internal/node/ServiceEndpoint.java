package org.robotui.ros.internal.node;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.message.MessageException;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageWriter;
import org.robotui.message.ServiceCodec;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.CloseableSet;
import org.robotui.ros.GraphName;
import org.robotui.ros.LinkEvent.Kind;
import org.robotui.ros.LinkState;
import org.robotui.ros.ServiceException;
import org.robotui.ros.ServiceHandler;
import org.robotui.ros.ServiceServer;
import org.robotui.ros.internal.tcpros.ConnectionHeader;
import org.robotui.ros.internal.tcpros.ProtocolException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A service this node offers: answers the clients' connections. */
final class ServiceEndpoint<Q, R> implements ServiceServer {

  private static final Logger LOG = LoggerFactory.getLogger(ServiceEndpoint.class);

  private final NodeContext context;
  private final GraphName name;
  private final ServiceCodec<Q, R> codec;
  private final ServiceHandler<Q, R> handler;
  private final Consumer<ServiceEndpoint<?, ?>> onClose;
  private final CloseableSet sockets = new CloseableSet();

  ServiceEndpoint(NodeContext context, GraphName name, ServiceCodec<Q, R> codec, ServiceHandler<Q, R> handler,
      Consumer<ServiceEndpoint<?, ?>> onClose) {
    this.context = context;
    this.name = name;
    this.codec = codec;
    this.handler = handler;
    this.onClose = onClose;
  }

  /** Serves one client on the calling thread until the connection ends. */
  void serve(TcpServer.Connection connection) throws IOException {
    ConnectionHeader request = connection.header();
    String client = request.field("callerid").map(PeerText::name).orElse("unnamed");
    String md5 = request.field("md5sum").orElse(MessageInfo.ANY);
    if (!new MessageInfo(codec.type(), codec.md5(), "").accepts(md5)) {
      String reason = "it is " + codec.type() + " with MD5 sum " + codec.md5() + ", but the client wants " + md5;
      failed(client, reason);
      throw new ProtocolException("service " + name + ": " + reason);
    }
    connection.socket().getOutputStream().write(reply().encode());
    if (!request.flag("probe") && sockets.add(connection.socket())) {
      answerAll(connection, client, request.flag("persistent"));
    }
  }

  private ConnectionHeader reply() {
    return ConnectionHeader.of(context.name().text()).with("type", codec.type()).with("md5sum", codec.md5())
        .with("request_type", codec.request().info().type()).with("response_type", codec.response().info().type());
  }

  private void answerAll(TcpServer.Connection connection, String client, boolean persistent) {
    try {
      do {
        byte[] request = connection.in().next(context.options().maxMessageBytes(), "request");
        connection.socket().getOutputStream().write(answer(request, client));
      } while (persistent);
    } catch (EOFException e) {
      LOG.trace("{}: {} closed its connection to {}", context.name(), client, name);
    } catch (IOException e) {
      failed(client, e.getMessage());
    } catch (MessageException e) {
      failed(client, "request that is no " + codec.type() + ": " + e.getMessage());
    } finally {
      sockets.close(connection.socket());
    }
  }

  private byte[] answer(byte[] request, String client) throws MessageException {
    Q decoded = decode(request);
    try {
      R response = handler.handle(decoded, client);
      return reply(1, out -> codec.response().encode(response, out));
    } catch (ServiceException e) {
      return refusal(e.getMessage());
    } catch (RuntimeException e) {
      LOG.error("{}: handler of {} failed", context.name(), name, e);
      return refusal("the handler failed: " + e);
    }
  }

  private Q decode(byte[] request) throws MessageException {
    try {
      return codec.request().decode(ByteBuffer.wrap(request).order(ByteOrder.LITTLE_ENDIAN));
    } catch (RuntimeException e) {
      throw new MessageException("decoding failed with " + e, "", 0);
    }
  }

  /** The text of a refusal is the whole frame: it has one length, not two. */
  private static byte[] refusal(String reason) {
    byte[] text = Optional.ofNullable(reason).orElse("").getBytes(java.nio.charset.StandardCharsets.UTF_8);
    return reply(0, out -> out.bytes(text, 0, text.length));
  }

  private static byte[] reply(int ok, Consumer<MessageWriter> body) {
    MessageWriter out = new MessageWriter();
    out.u8(ok).i32(0);
    body.accept(out);
    out.patchI32(1, out.size() - 1 - Integer.BYTES);
    return out.toByteArray();
  }

  private void failed(String client, String cause) {
    context.report(Kind.SERVICE, name.text(), client,
        new LinkState.Closed("service " + name + ": client " + client + ": " + cause));
  }

  @Override
  public GraphName name() {
    return name;
  }

  @Override
  public void close() {
    onClose.accept(this);
    sockets.close();
  }
}
