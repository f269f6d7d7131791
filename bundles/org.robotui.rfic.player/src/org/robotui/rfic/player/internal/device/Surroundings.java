package org.robotui.rfic.player.internal.device;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.function.Predicate;
import org.robotui.api.RficContext;
import org.robotui.api.link.Pulse;
import org.robotui.api.port.RawDefinition;
import org.robotui.data.array.Bytes;
import org.robotui.player.layout.Layouts;
import org.robotui.player.layout.MessageLayout;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;
import org.robotui.rfic.player.internal.convert.PlayerShapes;
import org.robotui.rfic.player.internal.convert.RecordView;
import org.robotui.rfic.player.internal.convert.Sonars;
import org.robotui.rfic.player.internal.link.Stamps;

/**
 * What all devices of a server share.
 *
 * @param context what core gives
 * @param layouts the known interfaces
 * @param tree the robot's frames
 * @param stamps reads the server's time
 * @param pulse hears of all data
 * @param sonars what Player does not tell of sonars
 * @param base tells of a device whether its odometry moves the base
 * @param carrier tells of a device whether it is needed to know where others are
 * @param peer the server as people write it
 */
public record Surroundings(RficContext context, Layouts layouts, FrameTree tree, Stamps stamps, Pulse pulse,
    Sonars.Beam sonars,
    Predicate<String> base, Predicate<String> carrier, String peer) {
  /** What the bytes of its messages are called, and what their definitions are. */
  static final String ENCODING = "player";

  boolean isBase(String device) {
    return base.test(device);
  }

  boolean carries(String device) {
    return carrier.test(device);
  }

  /** The name of a message, such as {@code position2d/state}; of one that is not known, its number. */
  String schema(PlayerMessage message) {
    String device = layouts.nameOf(message.device());
    String name = device.substring(0, device.lastIndexOf(':'));
    Optional<String> known = layouts.of(message).map(MessageLayout::name);
    return name + "/" + known.orElseGet(() -> Integer.toString(message.subtype()));
  }

  /** The layout of a message in words, as the browser shows it. */
  Optional<RawDefinition> definition(PlayerMessage message) {
    return layouts.of(message).map(layout -> new RawDefinition(schema(message), ENCODING,
        Bytes.of(PlayerShapes.text(layout.payload()).getBytes(StandardCharsets.UTF_8))));
  }

  RecordView record(PlayerMessage message) throws PlayerException {
    return new RecordView(schema(message), layouts.decode(message));
  }
}
