package org.robotui.script.internal.engine;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.LongSupplier;
import org.robotui.api.script.ScriptOutcome;
import org.robotui.api.script.ScriptSource;

/**
 * One run of a script: whether it has to end, and how long it has computed. What counts is the time of the processor,
 * so that a machine that is busy ends nothing, and waiting begins the count anew: what is ended is a loop that never
 * waits.
 */
final class ScriptRun {
  private final ScriptSource source;
  private final ScriptLimits limits;
  private final LongSupplier computed;
  private final CompletableFuture<ScriptOutcome> outcome = new CompletableFuture<>();
  private Optional<Thread> thread = Optional.empty(); // under the lock
  private volatile Optional<String> stopped = Optional.empty();
  private long since; // only on the thread of the script

  /** Of a script; {@code computed} tells what the processor has spent on the calling thread, nanoseconds. */
  ScriptRun(ScriptSource source, ScriptLimits limits, LongSupplier computed) {
    this.source = source;
    this.limits = limits;
    this.computed = computed;
  }

  ScriptSource source() {
    return source;
  }

  CompletableFuture<ScriptOutcome> outcome() {
    return outcome;
  }

  /** On the thread of the script, before all else. False where it was stopped before. */
  synchronized boolean begin() {
    thread = Optional.of(Thread.currentThread());
    waited();
    return stopped.isEmpty();
  }

  /** On the thread of the script: nobody interrupts it any more. */
  synchronized void end() {
    thread = Optional.empty();
    Thread.interrupted(); // a stop that came with the end is not meant for the next one
  }

  /** From any thread. */
  synchronized void stop(String reason) {
    if (stopped.isEmpty()) {
      stopped = Optional.of(reason);
      thread.ifPresent(Thread::interrupt);
    }
  }

  Optional<String> stopped() {
    return stopped;
  }

  /** Asked by the engine again and again while the script computes. */
  void check() {
    if (stopped.isPresent()) {
      throw new Halt(stopped.get(), Place.now());
    }
    if (computed.getAsLong() - since > limits.computing().toNanos()) {
      throw new Halt("it computed for " + PlainText.of(limits.computing())
          + " without waiting, as an endless loop does; let it wait now and then: sleep(0.1)", Place.now());
    }
    if (limits.heap().isFull()) {
      throw new Halt("the memory of RobotUI is nearly used up, and this script may be what fills it", Place.now());
    }
  }

  /** It has waited, or begins. */
  void waited() {
    since = computed.getAsLong();
  }
}
