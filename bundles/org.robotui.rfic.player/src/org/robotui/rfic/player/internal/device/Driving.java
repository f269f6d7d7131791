package org.robotui.rfic.player.internal.device;

import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import org.robotui.api.port.CommandSink;
import org.robotui.data.command.Motion;
import org.robotui.player.client.DeviceState;

/**
 * Sends motions to a device, which is opened with the first one, and remembers whether it is we who drive. Motor power
 * is never touched.
 *
 * @param <C> the motion
 */
final class Driving<C extends Motion<C>> implements CommandSink<C> {
  private final DeviceFeed feed;
  private final Predicate<C> out;
  private final Predicate<C> halt;
  private final C zero;
  private final Function<C, Optional<String>> refusal;
  private volatile boolean moving;
  private volatile boolean drove;

  /**
   * Drives a device.
   *
   * @param out sends to it where it is open
   * @param halt sends a stop, as far as possible also where it is not open
   * @param refusal tells why it cannot take a command at all
   */
  Driving(DeviceFeed feed, Predicate<C> out, Predicate<C> halt, C zero, Function<C, Optional<String>> refusal) {
    this.feed = feed;
    this.out = out;
    this.halt = halt;
    this.zero = zero;
    this.refusal = refusal;
    feed.onLost(() -> moving = false); // a server stops what a lost client drove; who drives after that is not us
    feed.whileBusy(() -> moving);
    feed.onClose(this::stop);
  }

  /** To be driven by us, a device is opened; to be told that it shall stand, only where it was we who drove. */
  @Override
  public Sent send(C command) {
    if (command.equals(zero) && !drove && !feed.open()) {
      return stop(zero, false);
    }
    return refusal.apply(command).<Sent>map(Sent.Refused::new).orElseGet(() -> tell(command));
  }

  private Sent tell(C command) {
    boolean stops = command.equals(zero);
    long silence = stops ? 0 : feed.around().pulse().silentFor(System.nanoTime());
    if (silence > 0) {
      return new Sent.Refused(String.format(Locale.ROOT,
          "the robot has not been heard for %.1f s; nothing is sent into a network that may keep it", silence / 1e9));
    }
    feed.linger();
    if (!out.test(command)) {
      return new Sent.Refused(obstacle(feed));
    }
    moving = !stops;
    drove |= moving;
    return new Sent.Out();
  }

  /**
   * The base takes the stop whoever drives it. It is said to a device that is closed, too: who does not look at it need
   * not open it for that.
   */
  @Override
  public Sent stop(C zero, boolean ours) {
    if (!ours && !feed.around().isBase(feed.name())) {
      return new Sent.Unneeded();
    }
    if (ours) {
      feed.linger();
    }
    if (!halt.test(zero)) {
      return new Sent.Refused(obstacle(feed));
    }
    moving = false;
    return new Sent.Out();
  }

  /** Why a device takes no commands now. */
  static String obstacle(DeviceFeed feed) {
    return switch (feed.device().state()) {
      case DeviceState.Refused refused -> refused.reason();
      case DeviceState.Waiting waiting -> feed.name() + " at " + feed.around().peer()
          + " is being opened; it takes commands in a moment";
      default -> feed.name() + " at " + feed.around().peer() + " is not linked";
    };
  }

  private void stop() {
    if (moving) {
      moving = false;
      out.test(zero);
    }
  }
}
