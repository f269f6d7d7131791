package org.robotui.ros.internal.node;

import java.io.Closeable;
import java.io.IOException;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import org.robotui.message.MessageException;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageWriter;
import org.robotui.message.ServiceCodec;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.CloseableSet;
import org.robotui.ros.GraphName;
import org.robotui.ros.ServiceClient;
import org.robotui.ros.internal.tcpros.ConnectionHeader;

/** Calls one service; a persistent caller keeps its connection and makes one call at a time. */
final class ServiceCaller<Q, R> implements ServiceClient<Q, R>, Closeable {

  private final NodeContext context;
  private final ServiceFinder finder;
  private final GraphName service;
  private final ServiceCodec<Q, R> codec;
  private final boolean persistent;
  private final CloseableSet sockets = new CloseableSet();
  private final ReentrantLock calling = new ReentrantLock();
  private Optional<ServiceLink> kept = Optional.empty();

  ServiceCaller(NodeContext context, ServiceFinder finder, GraphName service, ServiceCodec<Q, R> codec,
      boolean persistent) {
    this.context = context;
    this.finder = finder;
    this.service = service;
    this.codec = codec;
    this.persistent = persistent;
  }

  @Override
  public Outcome<R> call(Q request, Duration timeout) {
    Deadline deadline = Deadline.in(timeout);
    byte[] frame = frame(request);
    try {
      return decode(persistent ? onKeptLink(frame, deadline) : onOwnLink(frame, deadline));
    } catch (SocketTimeoutException e) {
      return new Outcome.TimedOut<>("service " + service + " did not answer in time", timeout);
    } catch (IOException e) {
      return new Outcome.Failed<>("service " + service + ": " + e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return new Outcome.Failed<>("service " + service + ": the calling thread was interrupted");
    }
  }

  private byte[] frame(Q request) {
    MessageWriter out = new MessageWriter();
    out.i32(0);
    codec.request().encode(request, out);
    out.patchI32(0, out.size() - Integer.BYTES);
    return out.toByteArray();
  }

  private Outcome<byte[]> onOwnLink(byte[] frame, Deadline deadline) throws IOException {
    try (ServiceLink link = new ServiceLink(context, sockets)) {
      open(link, deadline);
      return link.exchange(frame, deadline);
    }
  }

  private Outcome<byte[]> onKeptLink(byte[] frame, Deadline deadline) throws IOException, InterruptedException {
    if (!calling.tryLock(deadline.left().toNanos(), TimeUnit.NANOSECONDS)) {
      throw new SocketTimeoutException("other calls were not done in time");
    }
    boolean usable = false;
    try {
      kept.filter(ServiceLink::isStale).ifPresent(this::drop);
      Outcome<byte[]> outcome = link(deadline).exchange(frame, deadline);
      usable = true;
      return outcome;
    } finally {
      if (!usable) {
        kept.ifPresent(this::drop);
      }
      calling.unlock();
    }
  }

  private ServiceLink link(Deadline deadline) throws IOException {
    if (kept.isEmpty()) {
      kept = Optional.of(new ServiceLink(context, sockets));
      open(kept.get(), deadline);
    }
    return kept.get();
  }

  private void drop(ServiceLink link) {
    link.close();
    kept = Optional.empty();
  }

  private void open(ServiceLink link, Deadline deadline) throws IOException {
    ConnectionHeader request = ConnectionHeader.of(context.name().text()).with("service", service.text())
        .with("md5sum", codec.md5()).with("type", codec.type());
    link.open(finder.find(service, deadline), persistent ? request.with("persistent", "1") : request, deadline);
    String theirs = link.header().field("md5sum").orElse(MessageInfo.ANY);
    if (!new MessageInfo(codec.type(), codec.md5(), "").accepts(theirs)) {
      throw new IOException("it is " + link.header().field("type").orElse("another type") + " with MD5 sum " + theirs
          + ", expected " + codec.type() + " with " + codec.md5());
    }
  }

  private Outcome<R> decode(Outcome<byte[]> answer) {
    if (!(answer instanceof Outcome.Done<byte[]> done)) {
      return new Outcome.Refused<>(answer.reason());
    }
    try {
      return new Outcome.Done<>(codec.response().decode(ByteBuffer.wrap(done.value()).order(ByteOrder.LITTLE_ENDIAN)));
    } catch (MessageException | RuntimeException e) {
      return new Outcome.Failed<>(
          "service " + service + ": response that is no " + codec.type() + ": " + e.getMessage());
    }
  }

  @Override
  public void close() {
    finder.sockets().forget(this);
    sockets.close();
  }
}
