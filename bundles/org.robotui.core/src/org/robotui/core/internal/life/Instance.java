package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.api.ComponentType;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.fence.Thrown;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A running component with what each is given: threads of its own, and somebody who hears what goes wrong on them. */
abstract class Instance {
  private static final Logger LOG = LoggerFactory.getLogger(Instance.class);

  private final ComponentConfig config;
  private final ComponentHome home;
  private final TrackedThreads threads;

  /** Not started. */
  Instance(ComponentConfig config, ComponentHome home) {
    this.config = config;
    this.home = home;
    this.threads = new TrackedThreads(name(), this::died);
  }

  /** Creates and starts it. Blocks within limits. */
  abstract void start() throws Guarded.GuardException, InterruptedException;

  /** What it is an instance of. */
  abstract ComponentType type();

  /** What the type has created, once it has. */
  abstract Optional<?> made();

  /** Ends it within a limit. Returns what could not be ended of what it is known to have. */
  abstract Optional<String> end(Duration limit) throws InterruptedException;

  /** As {@link #end}, also where the thread is interrupted. */
  final Optional<String> close(Duration limit) {
    try {
      return end(limit);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.of(config.id() + ": closing was interrupted");
    }
  }

  private void died(Thread thread, Throwable error) {
    Thrown.log(LOG, thread.getName() + " ended", error);
    failed("its thread " + thread.getName() + " ended with " + Thrown.text(error));
  }

  /** It failed while it ran. */
  final void failed(String reason) {
    home.wake().failed(this, from(reason));
  }

  /** Tells the user what goes wrong. */
  final void complain(String what) {
    home.services().events().alert(home.ruicName(), from(what));
  }

  /** One more that runs tasks, and tells the user of one that throws. */
  final Background tasks() {
    Consumer<String> thrown = what -> complain(config.id() + " " + what);
    return new Background(name(), threads, thrown);
  }

  /** A message of what it left. */
  final String left(String what) {
    return from(config.id() + " " + what);
  }

  private String from(String what) {
    return what + " (" + origin() + ")";
  }

  /** Names bundle and class, for messages. */
  final String origin() {
    return home.services().registry().origin(type(), made().<Object>map(m -> m).orElse(type()));
  }

  /** How threads are named. */
  final String name() {
    return home.ruicName() + "." + config.id();
  }

  /** Its threads. */
  final TrackedThreads tracked() {
    return threads;
  }

  /** Its id in its RUIC. */
  public final String instance() {
    return config.id();
  }
}
