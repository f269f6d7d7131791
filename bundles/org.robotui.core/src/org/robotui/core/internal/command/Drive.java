package org.robotui.core.internal.command;

import org.robotui.api.command.Principal;

/** Something that we keep moving, or are just stopping. Guarded by its arbiter. */
final class Drive {
  /** Zero is sent more than once, as one datagram may be lost. */
  private static final int ZEROS = 3;
  private static final long SPACING_NANOS = 50_000_000L;

  private final CommandTarget<?> target;
  private final long generation;
  private Object owner;
  private Principal principal;
  private long expiresAt;
  private int zerosLeft;
  private long nextZeroAt;

  Drive(CommandTarget<?> target, Object owner, Principal principal, long expiresAt) {
    this.target = target;
    this.generation = target.link().generation();
    renew(owner, principal, expiresAt);
  }

  void renew(Object by, Principal as, long until) {
    owner = by;
    principal = as;
    expiresAt = until;
    zerosLeft = 0;
  }

  CommandTarget<?> target() {
    return target;
  }

  Principal principal() {
    return principal;
  }

  boolean isOf(Object output) {
    return owner == output;
  }

  boolean isMoving() {
    return zerosLeft == 0;
  }

  boolean expired(long now) {
    return now >= expiresAt;
  }

  boolean linkLost() {
    return !target.link().isUp() || target.link().generation() != generation;
  }

  /** Starts to stop. */
  void end(long now) {
    if (isMoving()) {
      zerosLeft = ZEROS;
      nextZeroAt = now;
    }
  }

  /** Sends the next zero if it is time; true where that was the last. */
  boolean zeroed(long now) {
    if (now >= nextZeroAt) {
      target.postZero();
      zerosLeft--;
      nextZeroAt = now + SPACING_NANOS;
    }
    return zerosLeft <= 0 || linkLost();
  }

  long nextDeadline() {
    return isMoving() ? expiresAt : nextZeroAt;
  }
}
