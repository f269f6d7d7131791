package org.robotui.ros2.internal.link;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import org.robotui.message.MessageException;
import org.robotui.net.log.LogThrottle;
import org.robotui.net.log.PeerText;
import org.robotui.net.thread.Workers;
import org.robotui.ros2.Ros2ServiceCodec;
import org.robotui.ros2.Ros2DeferringHandler;
import org.robotui.ros2.Ros2ServiceServer;
import org.robotui.ros2.internal.graph.UserData;
import org.robotui.ros2.name.DdsName;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Guid;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Reader;
import org.robotui.rtps.Sample;
import org.robotui.rtps.SampleIdentity;
import org.robotui.rtps.VendorId;
import org.robotui.rtps.Writer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A service that a node offers, with a thread that answers.
 *
 * @param <Q> the Java value of a request
 * @param <R> the Java value of a response
 */
public final class ServerLink<Q, R> implements Ros2ServiceServer {

  private static final Logger LOG = LoggerFactory.getLogger(ServerLink.class);
  private static final int MOST_CALLS = 1000;
  private static final long LOOK_MILLIS = 100;
  /** How long a client may take until it can hear the reply. */
  private static final Duration PATIENCE = Duration.ofMillis(500);

  private final Ends ends;
  private final Ros2Name name;
  private final Ros2ServiceCodec<Q, R> codec;
  private final Ros2DeferringHandler<Q, R> handler;
  private final BlockingQueue<Sample> calls = new ArrayBlockingQueue<>(MOST_CALLS);
  private final LogThrottle faults = new LogThrottle();
  private final Reader requests;
  private final Writer replies;
  private volatile boolean closed;

  /**
   * Announces it and starts its thread.
   *
   * @param ends where it is made
   * @param workers start the thread
   * @param name of the service
   * @param codec of its calls
   * @param qos of requests and replies
   * @param handler answers the calls
   */
  public ServerLink(Ends ends, Workers workers, Ros2Name name, Ros2ServiceCodec<Q, R> codec, Qos qos,
      Ros2DeferringHandler<Q, R> handler) {
    this.ends = ends;
    this.name = name;
    this.codec = codec;
    this.handler = handler;
    replies = ends.own(ends.participant().writer(new DdsName(DdsName.Role.REPLY, name).text(),
        DdsName.ofType(codec.response().type()), qos, UserData.of(codec.response().hash())));
    requests = ends.own(ends.participant().reader(new DdsName(DdsName.Role.REQUEST, name).text(),
        DdsName.ofType(codec.request().type()), qos, UserData.of(codec.request().hash()), this::received));
    workers.start("service " + name, this::run);
  }

  private void received(Sample sample) {
    if (sample.kind() == Sample.Kind.ALIVE && !closed && !calls.offer(sample)) {
      fault(sample, "more than " + MOST_CALLS + " calls wait");
    }
  }

  private void fault(Sample sample, String why) {
    if (faults.admit()) {
      LOG.warn("a call of {} by {} is not answered: {} ({} such calls)", name, caller(sample), PeerText.brief(why),
          faults.count());
    }
  }

  private String caller(Sample sample) {
    return ends.graph().node(sample.writer()).map(Ros2Name::text).orElseGet(() -> sample.writer().toString());
  }

  private void run() {
    while (!closed) {
      try {
        Sample sample = calls.poll(LOOK_MILLIS, TimeUnit.MILLISECONDS);
        if (sample != null) {
          answer(sample);
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return;
      }
    }
  }

  private void answer(Sample sample) {
    boolean headed = sample.related().isEmpty() && ends.graph().vendor(sample.writer()).equals(VendorId.CYCLONE_DDS);
    Optional<CallHeader.Opened> opened = headed ? CallHeader.open(sample.payload()) : Optional.empty();
    try {
      Q request = codec.request().decode(opened.map(CallHeader.Opened::payload).orElseGet(sample::payload));
      handler.handle(request, caller(sample)).whenComplete((response, failure) -> {
        if (failure == null) {
          reply(sample, opened, response);
        } else {
          fault(sample, String.valueOf(failure.getMessage()));
        }
      });
    } catch (MessageException | RuntimeException e) {
      fault(sample, String.valueOf(e.getMessage()));
      LOG.debug("a call of {} failed", name, e);
    }
  }

  private void reply(Sample sample, Optional<CallHeader.Opened> opened, R response) {
    ByteBuffer reply = codec.response().encode(response);
    awaitClient(sample.writer());
    if (opened.isPresent()) {
      replies.write(opened.get().header().before(reply));
    } else {
      replies.write(reply, identity(sample));
    }
  }

  /** Clients of Fast DDS name the end that reads replies. */
  private static SampleIdentity identity(Sample sample) {
    Guid client = sample.related().map(SampleIdentity::writer).filter(end -> !end.equals(Guid.UNKNOWN))
        .orElse(sample.writer());
    return new SampleIdentity(client, sample.sequence());
  }

  /** A client may call before this end knows where it reads; what is sent earlier is lost for it. */
  private void awaitClient(Guid client) {
    Waiting.until(PATIENCE, () -> closed,
        () -> replies.matched().stream().anyMatch(end -> end.guid().prefix().equals(client.prefix())));
  }

  @Override
  public Ros2Name name() {
    return name;
  }

  @Override
  public void close() {
    closed = true;
    ends.close(this, requests, replies);
  }
}
