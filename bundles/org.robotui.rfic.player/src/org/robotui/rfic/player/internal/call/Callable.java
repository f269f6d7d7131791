package org.robotui.rfic.player.internal.call;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.robotui.player.layout.InterfaceLayout;
import org.robotui.player.layout.Layouts;
import org.robotui.player.layout.MessageLayout;
import org.robotui.player.wire.MessageType;
import org.robotui.rfic.player.internal.device.DeviceFeed;
import org.robotui.rfic.player.internal.link.Devices;

/**
 * What a device can be asked or told by name. Commands that drive are not among them: a call has no limits, no expiry
 * and no end.
 *
 * @param feed the device
 * @param message a request or a command
 */
record Callable(DeviceFeed feed, MessageLayout message) {
  private static final Set<String> DRIVING = Set.of("position1d", "position2d", "position3d", "actarray", "limb");
  private static final String EVERY_DEVICE = "any";

  String name() {
    return feed.name() + "/" + message.name();
  }

  static Optional<Callable> find(String name, Devices devices, Layouts layouts) {
    int slash = name.indexOf('/');
    return slash < 0 ? Optional.empty()
        : devices.find(name.substring(0, slash)).flatMap(
            feed -> of(feed, layouts).filter(c -> c.message.name().equals(name.substring(slash + 1))).findFirst());
  }

  static List<Callable> all(Devices devices, Layouts layouts) {
    return devices.all().values().stream().flatMap(feed -> of(feed, layouts)).toList();
  }

  private static Stream<Callable> of(DeviceFeed feed, Layouts layouts) {
    String kind = layouts.byCode(feed.device().id().interfaceCode()).map(InterfaceLayout::name).orElse("");
    Stream<MessageLayout> commands =
        DRIVING.contains(kind) ? Stream.empty() : feed.messages(MessageType.COMMAND).stream();
    Stream<MessageLayout> common = layouts.byName(EVERY_DEVICE).stream().flatMap(any -> any.messages().stream());
    return Stream.of(feed.messages(MessageType.REQUEST).stream(), commands, common).flatMap(m -> m)
        .map(m -> new Callable(feed, m));
  }
}
