package org.robotui.rfic.player.internal.device;

import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import org.robotui.api.port.CommandSink;
import org.robotui.data.Motion;
import org.robotui.player.client.DeviceState;

/**
 * Sends motions to a device, which is opened with the first one, and remembers whether it is we who drive. Motor power is never touched.
 *
 * @param <C> the motion
 */
final class Driving<C extends Motion<C>> implements CommandSink<C> {
  private final DeviceFeed feed;
  private final Predicate<C> out;
  private final C zero;
  private final Function<C, Optional<String>> refusal;
  private volatile boolean moving;

  Driving(DeviceFeed feed, Predicate<C> out, C zero) {
    this(feed, out, zero, command -> Optional.empty());
  }

  /** The last tells why a device cannot take a command at all. */
  Driving(DeviceFeed feed, Predicate<C> out, C zero, Function<C, Optional<String>> refusal) {
    this.feed = feed;
    this.out = out;
    this.zero = zero;
    this.refusal = refusal;
    feed.onOpen(() -> moving = false); // a server stops what a lost client drove; who drives after that is not us
    feed.onClose(this::stop);
  }

  @Override
  public Sent send(C command) {
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
    return new Sent.Out();
  }

  /** Why a device takes no commands now. */
  static String obstacle(DeviceFeed feed) {
    return switch (feed.device().state()) {
      case DeviceState.Refused refused -> refused.reason();
      case DeviceState.Waiting waiting -> feed.name() + " at " + feed.around().peer() + " is being opened; say it again in a moment";
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
