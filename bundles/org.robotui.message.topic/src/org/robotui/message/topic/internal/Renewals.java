package org.robotui.message.topic.internal;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import org.robotui.api.port.CallException;
import org.robotui.api.port.ServiceOffer;

/**
 * What is offered by name as long as its offer is made again and again. Safe for all threads.
 *
 * @param <Q> what is asked to be offered
 * @param <H> what it is once it is offered
 */
public final class Renewals<Q, H extends AutoCloseable> {
  private static final long LIFETIME = Duration.ofSeconds(ServiceOffer.LIFETIME_SECONDS).toNanos();

  private final Consumer<H> end;
  private final Map<String, Held<Q, H>> held = new HashMap<>();
  private boolean closed;

  /** Offers nothing yet. */
  public Renewals(Consumer<H> end) {
    this.end = end;
  }

  /** One name, whose offer may be replaced by a later one of the same type. */
  public static final class Held<Q, H> {
    private final String type;
    private Optional<H> open = Optional.empty();
    private volatile Q asked;
    private volatile long until;

    private Held(String type, Q asked) {
      this.type = type;
      renew(asked);
    }

    private void renew(Q again) {
      asked = again;
      until = System.nanoTime() + LIFETIME;
    }

    /** What was asked for last. */
    public Q asked() {
      return asked;
    }
  }

  /** Whether it is offered already, with the same type. */
  public synchronized boolean renewed(String name, String type, Q asked) {
    Held<Q, H> known = held.get(name);
    if (known == null || !known.type.equals(type)) {
      return false;
    }
    known.renew(asked);
    return true;
  }

  /** Offers it no longer. */
  public synchronized void leave(String name) {
    Optional.ofNullable(held.remove(name)).ifPresent(this::end);
  }

  /** Offers it, in place of one of another type. */
  public synchronized void adopt(String name, String type, Q asked, Function<Held<Q, H>, H> opening)
      throws CallException {
    if (closed) {
      throw new CallException("the connection is being closed");
    }
    leave(name);
    Held<Q, H> made = new Held<>(type, asked);
    try {
      made.open = Optional.of(opening.apply(made));
    } catch (IllegalArgumentException | IllegalStateException e) {
      throw new CallException(name + " cannot be offered: " + e.getMessage(), e);
    }
    held.put(name, made);
  }

  private void end(Held<Q, H> gone) {
    gone.open.ifPresent(end);
  }

  /** Gives up what is not offered any more, and looks after the rest. */
  public synchronized void tick(Consumer<H> care) {
    long now = System.nanoTime();
    held.values().removeIf(each -> {
      boolean over = now - each.until > 0;
      if (over) {
        end(each);
      } else {
        each.open.ifPresent(care);
      }
      return over;
    });
  }

  /** What is offered now. */
  public synchronized Set<String> names() {
    return Set.copyOf(held.keySet());
  }

  /** Offers nothing any more. */
  public synchronized void close() {
    closed = true;
    held.values().forEach(this::end);
    held.clear();
  }
}
