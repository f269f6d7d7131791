package org.robotui.rfic.ros2.internal.convert;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.ros2.Ros2Types;

/**
 * Finds types on a thread of its own, as that may read files and wait for the nodes of the robot. What was found is
 * remembered; what was not is looked for again after a while. Safe for all threads.
 */
public final class TypeLookups implements AutoCloseable {
  private static final Duration PATIENCE = Duration.ofSeconds(4);
  private static final Duration AGAIN = Duration.ofSeconds(10);
  private static final Duration IDLE = Duration.ofSeconds(5);
  /** Peers choose names and sums. */
  private static final int MOST = 1000;

  /** A version of a type. */
  private record Version(TypeName name, Optional<TypeHash> hash) {}

  /** What is known of it; nothing while it is looked for. */
  private record Answer(Optional<SchemaLookup<MessageSchema>> lookup, long atNanos) {
    boolean old() {
      return lookup.filter(SchemaLookup.Missing.class::isInstance).isPresent()
          && System.nanoTime() - atNanos > AGAIN.toNanos();
    }
  }

  private final Ros2Types types;
  private final Map<Version, Answer> answers = new ConcurrentHashMap<>();
  private final ThreadPoolExecutor worker;

  /**
   * Knows nothing yet.
   *
   * @param types finds them
   * @param threads makes the thread, which lives while there is something to find
   */
  public TypeLookups(Ros2Types types, ThreadFactory threads) {
    this.types = types;
    this.worker = new ThreadPoolExecutor(1, 1, IDLE.toMillis(), TimeUnit.MILLISECONDS, new LinkedBlockingQueue<>(MOST),
        threads, new ThreadPoolExecutor.DiscardPolicy());
    worker.allowCoreThreadTimeOut(true);
  }

  /**
   * The answer, as far as it is known now; it is looked for from now on where it is not. Does not wait.
   *
   * @param name the type
   * @param hash the sum that a peer announced
   * @return the type, or why there is none; empty while it is looked for
   */
  public Optional<SchemaLookup<MessageSchema>> find(TypeName name, Optional<TypeHash> hash) {
    Version version = new Version(name, hash);
    Answer answer = answers.get(version);
    if (answer != null && !answer.old()) {
      return answer.lookup();
    }
    if (answer == null && answers.size() >= MOST) {
      return Optional.of(new SchemaLookup.Missing<>("more than " + MOST + " versions of types were met"));
    }
    Optional<SchemaLookup<MessageSchema>> before = answer == null ? Optional.empty() : answer.lookup();
    answers.put(version, new Answer(before, System.nanoTime()));
    worker.execute(() -> note(version, types.message(name, hash, PATIENCE)));
    return before;
  }

  /**
   * The answer without asking the robot. May read files.
   *
   * @param name the type
   * @param hash the sum that a peer announced
   * @return the type, or why there is none
   */
  public SchemaLookup<MessageSchema> known(TypeName name, Optional<TypeHash> hash) {
    Version version = new Version(name, hash);
    Answer answer = answers.get(version);
    if (answer != null && answer.lookup().orElse(null) instanceof SchemaLookup.Found<MessageSchema> found) {
      return found;
    }
    SchemaLookup<MessageSchema> lookup = types.registry().message(name, hash);
    if (lookup instanceof SchemaLookup.Found && (answer != null || answers.size() < MOST)) {
      note(version, lookup);
    }
    return lookup;
  }

  private void note(Version version, SchemaLookup<MessageSchema> lookup) {
    answers.put(version, new Answer(Optional.of(lookup), System.nanoTime()));
  }

  /** Looks for nothing more. */
  @Override
  public void close() {
    worker.shutdownNow();
  }
}
