package org.robotui.ros.internal.node;

import java.io.IOException;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.robotui.message.MessageException;
import org.robotui.message.MessageInfo;
import org.robotui.net.call.Backoff;
import org.robotui.net.call.Outcome;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.CloseableSet;
import org.robotui.net.socket.DeadlineInput;
import org.robotui.net.socket.HostPort;
import org.robotui.net.socket.Sockets;
import org.robotui.ros.LinkEvent.Kind;
import org.robotui.ros.LinkState;
import org.robotui.ros.Reception;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.internal.tcpros.ConnectionHeader;
import org.robotui.ros.internal.tcpros.FrameReader;
import org.robotui.ros.internal.tcpros.ProtocolException;
import org.robotui.ros.internal.tcpros.ReadPacing;

/**
 * The link to one publisher, with a thread of its own that connects, reads and, when the link broke, connects again.
 */
final class InLink {

  private static final int BUFFER = 64 * 1024;

  private final NodeContext context;
  private final SubscribedTopic topic;
  private final String publisherUri;
  private final LinkDelivery delivery;
  private final CloseableSet open = new CloseableSet();
  /** Ends a pause early. */
  private final Semaphore nudges = new Semaphore(0);
  private final Traffic got = new Traffic();
  private final Backoff backoff;
  private volatile boolean closed;
  private volatile boolean orphan;
  /** The type of what comes, while it is connected. */
  private volatile Optional<MessageInfo> announced = Optional.empty();
  private volatile String peer;

  InLink(NodeContext context, SubscribedTopic topic, String publisherUri) {
    this.context = context;
    this.topic = topic;
    this.publisherUri = publisherUri;
    this.delivery = new LinkDelivery(topic, this::describe);
    this.backoff = context.backoff();
    this.peer = publisherUri;
  }

  void start() {
    context.start("sub " + topic.topic() + " " + publisherUri, this::run);
  }

  boolean isConnected() {
    return announced.isPresent();
  }

  /** Whether it is connected to a publisher of such messages. */
  boolean brings(MessageInfo wanted) {
    return announced.filter(theirs -> wanted.accepts(theirs.md5())).isPresent();
  }

  /** What comes goes to the subscribers through it. */
  LinkDelivery delivery() {
    return delivery;
  }

  /** Hands over to one more subscriber, on a thread that may wait, what the publisher keeps. */
  void joined(Subscription<?> subscription) {
    if (delivery.hasKept(subscription)) {
      context.start("sub " + topic.topic() + " " + publisherUri + " kept", () -> delivery.catchUp(subscription));
    }
  }

  /** What came in, also over connections before the present one. */
  Traffic got() {
    return got;
  }

  /** The publisher's node name, or its address before it said its name. */
  String peer() {
    return peer;
  }

  /** Whether no further attempt is to be made. */
  boolean isOver() {
    return closed || orphan;
  }

  String publisherUri() {
    return publisherUri;
  }

  /**
   * The master does not list the publisher any more: the link lives as long as the publisher keeps it, but is not made
   * again.
   */
  void orphan() {
    orphan = true;
    nudges.release();
  }

  /** The master lists the publisher (again): no reason to wait. */
  void nudge() {
    orphan = false;
    nudges.release();
  }

  void close() {
    closed = true;
    open.close();
    nudges.release();
  }

  private void run() {
    String last = "the publisher is not registered any more";
    while (!topic.ended(this, publisherUri)) {
      report(new LinkState.Connecting());
      last = attempt();
      if (!isOver()) {
        Duration pause = backoff.next();
        report(new LinkState.Failed(last, pause));
        pause(pause);
      }
    }
    report(new LinkState.Closed(closed ? "closed by this node" : last));
  }

  private String attempt() {
    long start = System.nanoTime();
    try {
      connect();
      return "";
    } catch (SocketTimeoutException e) {
      return describe("no answer within " + context.handshake().toMillis() + " ms");
    } catch (IOException | IllegalArgumentException e) {
      return describe(e.getMessage());
    } catch (OutOfMemoryError e) {
      return describe("no memory for its message: " + e.getMessage());
    } catch (MessageException e) {
      return e.problem();
    } finally {
      announced = Optional.empty();
      delivery.forget();
      if (System.nanoTime() - start > context.options().maxBackoff().toNanos()) {
        backoff.reset();
      }
    }
  }

  private void connect() throws IOException, MessageException {
    HostPort target = requestTopic();
    Socket socket = context.options().sockets().createSocket();
    if (!open.add(socket)) {
      return;
    }
    try {
      target.connect(socket, context.handshake());
      Sockets.prepare(socket);
      converse(socket);
    } finally {
      open.close(socket);
    }
  }

  private HostPort requestTopic() throws IOException {
    RosApi publisher = new RosApi(HostPort.ofUri(publisherUri, "http"), "", context.handshake());
    if (!open.add(publisher)) {
      throw new IOException("closed");
    }
    try {
      Outcome<XmlRpcValue> outcome = publisher.call("requestTopic", XmlRpcValue.of(context.name().text()),
          XmlRpcValue.of(topic.topic().text()), XmlRpcValue.of(XmlRpcValue.ofTexts(List.of("TCPROS"))));
      return outcome instanceof Outcome.Done<XmlRpcValue> done ? endpoint(done.value()) : raise(outcome.reason());
    } finally {
      open.close(publisher);
    }
  }

  private static HostPort raise(String reason) throws IOException {
    throw new IOException(reason);
  }

  private static HostPort endpoint(XmlRpcValue value) throws IOException {
    List<XmlRpcValue> parts = GraphCodec.list(value);
    if (parts.size() >= 3 && parts.get(1) instanceof XmlRpcValue.Text host
        && parts.get(2) instanceof XmlRpcValue.Int port) {
      return new HostPort(host.value(), port.value());
    }
    throw new ProtocolException("requestTopic did not answer [TCPROS, host, port]");
  }

  private void converse(Socket socket) throws IOException, MessageException {
    DeadlineInput stream = new DeadlineInput(socket, 0);
    stream.within(context.handshake());
    socket.getOutputStream().write(topic.request().encode());
    FrameReader in = new FrameReader(stream, BUFFER);
    ConnectionHeader header = ConnectionHeader.decode(in.next(context.options().maxHeaderBytes(), "connection header"));
    header.field("callerid").ifPresent(name -> peer = PeerText.name(name));
    MessageInfo theirs = accept(header);
    stream.withoutDeadline();
    announced = Optional.of(theirs);
    report(new LinkState.Connected(peer, theirs));
    receive(in, theirs, header.flag("latching"));
  }

  private MessageInfo accept(ConnectionHeader header) throws ProtocolException {
    if (header.field("error").isPresent()) {
      throw new ProtocolException("the publisher refused: " + header.require("error"));
    }
    MessageInfo theirs = header.messageInfo();
    boolean wanted = topic.subscriptions().stream().anyMatch(each -> each.codec().info().accepts(theirs.md5()));
    Optional<Subscription<?>> any = topic.subscriptions().stream().findFirst();
    if (!wanted && any.isPresent()) {
      throw new ProtocolException(any.get().mismatch(theirs));
    }
    return theirs;
  }

  private void receive(FrameReader in, MessageInfo theirs, boolean latching) throws IOException, MessageException {
    long max = context.options().maxMessageBytes();
    String caller = peer;
    ReadPacing pacing = new ReadPacing();
    while (!closed) {
      if (pacing.isFlood() && !in.hasBuffered()) {
        LockSupport.parkNanos(ReadPacing.PAUSE_NANOS);
      }
      byte[] frame = in.next(max, "message");
      long now = System.nanoTime();
      pacing.count(frame.length, now);
      got.count(1, frame.length + (long) Integer.BYTES);
      ByteBuffer raw = ByteBuffer.wrap(frame).asReadOnlyBuffer().order(ByteOrder.LITTLE_ENDIAN);
      delivery.deliver(frame, new Reception(caller, now, raw, theirs, latching));
    }
  }

  private void pause(Duration time) {
    try {
      nudges.tryAcquire(time.toNanos(), TimeUnit.NANOSECONDS);
      nudges.drainPermits();
    } catch (InterruptedException e) {
      closed = true;
      Thread.currentThread().interrupt();
    }
  }

  private String describe(String cause) {
    String uri = PeerText.name(publisherUri);
    String node = peer.equals(publisherUri) ? uri : peer + " at " + uri;
    return "topic " + topic.topic() + ": publisher " + node + ": " + cause;
  }

  private void report(LinkState state) {
    context.report(Kind.SUBSCRIPTION, topic.topic().text(), peer, state);
  }
}
