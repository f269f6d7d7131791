package org.robotui.ros.internal.node;

import java.io.IOException;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.LongAdder;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.robotui.message.MessageCodec;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageWriter;
import org.robotui.net.log.PeerText;
import org.robotui.net.socket.Sockets;
import org.robotui.ros.GraphName;
import org.robotui.ros.LinkEvent;
import org.robotui.ros.LinkState;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.internal.tcpros.ConnectionHeader;
import org.robotui.ros.internal.tcpros.FrameReader;
import org.robotui.ros.internal.tcpros.OutQueue;
import org.robotui.ros.internal.tcpros.ProtocolException;

/** One topic this node publishes, with the links to its subscribers. */
final class Publication<T> implements Publisher<T> {
  private static final long LOOK_NANOS = 500_000;
  private static final Optional<String> ITSELF = Optional.of("");

  private final NodeContext context;
  private final GraphName topic;
  private final MessageCodec<T> codec;
  private final PublisherOptions options;
  private final Consumer<Publication<?>> onClose;
  private final LongAdder dropped = new LongAdder();
  /** Bytes over links that ended. */
  private final LongAdder sentBefore = new LongAdder();
  private final List<OutLink> links = new CopyOnWriteArrayList<>();
  /** Orders messages against each other and against new links. */
  private final Object sending = new Object();
  /** By sender, in the order in which they came. */
  private final SequencedMap<String, ByteBuffer> latched = new LinkedHashMap<>();
  private volatile int expectedSize = 256;
  private volatile boolean closed;

  Publication(NodeContext context, GraphName topic, MessageCodec<T> codec, PublisherOptions options,
      Consumer<Publication<?>> onClose) {
    this.context = context;
    this.topic = topic;
    this.codec = codec;
    this.options = options;
    this.onClose = onClose;
  }

  @Override
  public void publish(T message) {
    publish(message, ITSELF);
  }

  @Override
  public void publish(T message, Optional<String> keptFor) {
    send(message, keptFor, OutLink::offer);
  }

  @Override
  public void publishUrgently(T message) {
    send(message, ITSELF, OutLink::offerUrgently);
  }

  private void send(T message, Optional<String> keptFor, BiConsumer<OutLink, ByteBuffer> way) {
    if (closed || links.isEmpty() && !options.latch()) {
      return;
    }
    ByteBuffer frame = frame(message);
    synchronized (sending) {
      keptFor.filter(sender -> options.latch()).ifPresent(sender -> latched.putLast(sender, frame));
      for (OutLink link : links) {
        way.accept(link, frame);
      }
    }
  }

  private ByteBuffer frame(T message) {
    MessageWriter writer = new MessageWriter(expectedSize);
    writer.i32(0);
    codec.encode(message, writer);
    writer.patchI32(0, writer.size() - Integer.BYTES);
    expectedSize = writer.size();
    return writer.view();
  }

  /** Serves one subscriber on the calling thread until the link ends. */
  void serve(Socket socket, FrameReader in, ConnectionHeader request) throws IOException {
    String subscriber = request.field("callerid").map(PeerText::name).orElse("unnamed");
    MessageInfo theirs = new MessageInfo(request.field("type").orElse(MessageInfo.ANY), request.require("md5sum"),
        request.field("message_definition").orElse(""));
    if (!codec.info().accepts(theirs.md5())) {
      String reason = "topic " + topic + " is " + codec.info().type() + " with MD5 sum " + codec.info().md5()
          + ", but " + subscriber + " wants " + theirs.type() + " with " + theirs.md5();
      context.report(LinkEvent.Kind.PUBLICATION, topic.text(), subscriber, new LinkState.Closed(reason));
      throw new ProtocolException(reason);
    }
    socket.getOutputStream().write(reply().encode());
    OutQueue queue = new OutQueue(options.queueMessages(), options.queueBytes(), dropped);
    if (options.prompt()) {
      Sockets.minimizeSendBuffer(socket);
    }
    OutLink link = new OutLink(context, topic, subscriber, theirs, socket, queue, new Traffic());
    add(link);
    try {
      link.run(in);
    } finally {
      sentBefore.add(link.sent().bytes());
      links.remove(link);
    }
  }

  private void add(OutLink link) throws IOException {
    synchronized (sending) {
      links.add(link);
      latched.values().forEach(link::offer);
    }
    if (closed) {
      links.remove(link);
      throw new IOException("the publisher was closed");
    }
  }

  private ConnectionHeader reply() {
    return ConnectionHeader.of(context.name().text()).with(codec.info()).with("topic", topic.text())
        .with("latching", options.latch() ? "1" : "0");
  }

  MessageInfo info() {
    return codec.info();
  }

  /** What all subscribers so far got. */
  long sentBytes() {
    return sentBefore.sum() + links.stream().mapToLong(link -> link.sent().bytes()).sum();
  }

  List<OutLink> links() {
    return links;
  }

  @Override
  public boolean awaitSent(Duration patience) {
    long end = System.nanoTime() + patience.toNanos();
    while (!links.stream().allMatch(OutLink::isIdle)) {
      if (System.nanoTime() - end > 0) {
        return false;
      }
      LockSupport.parkNanos(LOOK_NANOS);
    }
    return true;
  }

  @Override
  public GraphName topic() {
    return topic;
  }

  @Override
  public int numSubscribers() {
    return links.size();
  }

  @Override
  public Set<String> subscribers() {
    return links.stream().map(OutLink::subscriber).collect(Collectors.toUnmodifiableSet());
  }

  @Override
  public long dropped() {
    return dropped.sum();
  }

  @Override
  public void close() {
    synchronized (sending) {
      if (closed) {
        return;
      }
      closed = true;
    }
    onClose.accept(this);
    links.forEach(OutLink::close);
  }
}
