package org.robotui.ros2.internal.link;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;
import org.robotui.message.MessageException;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.Ros2ServiceClient;
import org.robotui.ros2.Ros2ServiceCodec;
import org.robotui.ros2.internal.graph.UserData;
import org.robotui.ros2.name.DdsName;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.Qos;
import org.robotui.rtps.Reader;
import org.robotui.rtps.Sample;
import org.robotui.rtps.SampleIdentity;
import org.robotui.rtps.VendorId;
import org.robotui.rtps.Writer;

/**
 * Calls of a node to one service.
 *
 * @param <Q> the Java value of a request
 * @param <R> the Java value of a response
 */
public final class ClientLink<Q, R> implements Ros2ServiceClient<Q, R> {

  private static final int MOST_CALLS = 1000;
  /** What Fast DDS has for a number that is not known. */
  private static final long NO_SEQUENCE = -1L << Integer.SIZE;

  /** Which request a reply is for. */
  private record Key(boolean header, long sequence) {}

  private final Ends ends;
  private final Ros2Name name;
  private final Ros2ServiceCodec<Q, R> codec;
  private final Writer requests;
  private final Reader replies;
  private final long id = ThreadLocalRandom.current().nextLong();
  private final Map<Key, CompletableFuture<Outcome<R>>> pending = new HashMap<>();
  private long headers;
  private boolean closed;

  /**
   * Announces it.
   *
   * @param ends where it is made
   * @param name of the service
   * @param codec of its calls
   * @param qos of requests and replies
   */
  public ClientLink(Ends ends, Ros2Name name, Ros2ServiceCodec<Q, R> codec, Qos qos) {
    this.ends = ends;
    this.name = name;
    this.codec = codec;
    replies = ends.own(ends.participant().reader(new DdsName(DdsName.Role.REPLY, name).text(),
        DdsName.ofType(codec.response().type()), qos, UserData.of(codec.response().hash()), this::received));
    requests = ends.own(ends.participant().writer(new DdsName(DdsName.Role.REQUEST, name).text(),
        DdsName.ofType(codec.request().type()), qos, UserData.of(codec.request().hash())));
  }

  @Override
  public Ros2Name name() {
    return name;
  }

  /** The servers of which both ends match, those that speak as Fast DDS does first. */
  private List<EndpointInfo> servers() {
    List<EndpointInfo> answering = replies.matched();
    return requests.matched().stream()
        .filter(taker -> answering.stream().anyMatch(end -> end.participant().equals(taker.participant()))).toList();
  }

  @Override
  public boolean ready() {
    return !servers().isEmpty();
  }

  @Override
  public boolean awaitServer(Duration patience) {
    return Waiting.until(patience, this::isClosed, this::ready);
  }

  private boolean isClosed() {
    synchronized (pending) {
      return closed;
    }
  }

  @Override
  public Outcome<R> call(Q request, Duration timeout) {
    long deadline = System.nanoTime() + timeout.toNanos();
    if (!awaitServer(timeout)) {
      return isClosed() ? new Outcome.Failed<>("service " + name + ": the client was closed") : absent(timeout);
    }
    CompletableFuture<Outcome<R>> answer = start(request);
    try {
      return answer.get(Math.max(0, deadline - System.nanoTime()), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      return new Outcome.TimedOut<>("service " + name + " of " + who() + " did not answer", timeout);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return new Outcome.Failed<>("service " + name + ": interrupted while waiting for the answer");
    } catch (ExecutionException e) {
      throw new IllegalStateException("answers do not fail otherwise", e);
    } finally {
      forget(answer);
    }
  }

  private Outcome<R> absent(Duration timeout) {
    List<String> misfits = Stream.concat(ends.mismatches(requests).stream(), ends.mismatches(replies).stream())
        .distinct().toList();
    String why = misfits.isEmpty() ? "" : ": " + String.join("; ", misfits);
    return new Outcome.TimedOut<>("service " + name + " has no server of type " + codec.type() + why, timeout);
  }

  private String who() {
    return servers().stream().map(end -> ends.graph().node(end.guid()).map(Ros2Name::text)
        .orElseGet(() -> end.guid().toString())).findFirst().orElse("a server that is gone");
  }

  @Override
  public CompletionStage<Outcome<R>> send(Q request) {
    return start(request).minimalCompletionStage();
  }

  private CompletableFuture<Outcome<R>> start(Q request) {
    ByteBuffer payload = codec.request().encode(request);
    boolean header = !servers().isEmpty()
        && servers().stream().allMatch(end -> ends.graph().vendor(end.guid()).equals(VendorId.CYCLONE_DDS));
    CompletableFuture<Outcome<R>> answer = new CompletableFuture<>();
    // a reply may come before the number of the request is known here
    synchronized (pending) {
      if (closed || pending.size() >= MOST_CALLS) {
        answer.complete(new Outcome.Failed<>(
            "service " + name + ": " + (closed ? "the client was closed" : "too many calls wait for their answers")));
        return answer;
      }
      Optional<Key> key = header ? withHeader(payload) : plain(payload);
      key.ifPresentOrElse(sent -> pending.put(sent, answer),
          () -> answer.complete(new Outcome.Failed<>("service " + name + ": the request could not be sent")));
    }
    return answer;
  }

  private Optional<Key> withHeader(ByteBuffer payload) {
    long sequence = ++headers;
    return requests.write(new CallHeader(id, sequence).before(payload)).isPresent()
        ? Optional.of(new Key(true, sequence))
        : Optional.empty();
  }

  /** Servers that know where replies are read can wait until they are. */
  private Optional<Key> plain(ByteBuffer payload) {
    OptionalLong sequence =
        requests.write(payload, new SampleIdentity(replies.info().guid(), NO_SEQUENCE));
    return sequence.isPresent() ? Optional.of(new Key(false, sequence.getAsLong())) : Optional.empty();
  }

  private void received(Sample sample) {
    if (sample.kind() != Sample.Kind.ALIVE) {
      return;
    }
    if (sample.related().isPresent()) {
      SampleIdentity request = sample.related().get();
      boolean ours = request.writer().equals(requests.info().guid()) || request.writer().equals(replies.info().guid());
      if (ours) {
        answer(new Key(false, request.sequence()), sample.payload(), sample);
      }
    } else {
      CallHeader.open(sample.payload()).filter(opened -> opened.header().client() == id)
          .ifPresent(opened -> answer(new Key(true, opened.header().sequence()), opened.payload(), sample));
    }
  }

  private void answer(Key key, ByteBuffer payload, Sample sample) {
    CompletableFuture<Outcome<R>> waiting;
    synchronized (pending) {
      waiting = pending.remove(key);
    }
    if (waiting == null) {
      return;
    }
    try {
      waiting.complete(new Outcome.Done<>(codec.response().decode(payload)));
    } catch (MessageException e) {
      String server = ends.graph().node(sample.writer()).map(Ros2Name::text).orElse(sample.writer().toString());
      waiting.complete(
          new Outcome.Failed<>("service " + name + ": the answer of " + server + " cannot be read: " + e.getMessage()));
    }
  }

  private void forget(CompletableFuture<Outcome<R>> answer) {
    synchronized (pending) {
      pending.values().remove(answer);
    }
  }

  @Override
  public void close() {
    List<CompletableFuture<Outcome<R>>> waiting;
    synchronized (pending) {
      closed = true;
      waiting = List.copyOf(pending.values());
      pending.clear();
    }
    ends.close(this, requests, replies);
    waiting.forEach(each -> each.complete(new Outcome.Failed<>("service " + name + ": the client was closed")));
  }
}
