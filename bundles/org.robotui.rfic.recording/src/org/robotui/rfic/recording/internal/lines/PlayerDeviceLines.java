package org.robotui.rfic.recording.internal.lines;

import java.util.List;
import java.util.Map;
import org.robotui.player.layout.Layouts;
import org.robotui.player.log.LogFormat;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerMessage;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordedSchema;

/** Lines of Player's driver writelog as the messages that they were made of, as live ones are recorded. */
public final class PlayerDeviceLines implements LineFormat {
  private static final String ENCODING = "player";
  private static final String MESSAGE = "player.message";
  private static final String ANSWER = "answer";

  private final Layouts layouts = Layouts.standard();
  private final LogFormat format = new LogFormat(layouts);
  private final LineChannels channels = new LineChannels();

  PlayerDeviceLines() {}

  /**
   * Whether a channel has what a device answers to a request, not what it says by itself.
   *
   * @param channel of messages of Player
   * @return true for answers, such as where a laser is on the robot
   */
  public static boolean isAnswer(RecordedChannel channel) {
    return channel.metadata().getOrDefault(MESSAGE, "").equals(ANSWER);
  }

  @Override
  public String name() {
    return PlayerLines.NAME;
  }

  @Override
  public List<RecordedChannel> channels() {
    return channels.all();
  }

  @Override
  public List<RecordedMessage> messages(String line) {
    return PlayerLines.parse(format, line).stream().filter(PlayerDeviceLines::isSaid).map(this::message).toList();
  }

  /** What others commanded is no part of what the robot says. */
  private static boolean isSaid(PlayerMessage message) {
    return message.type() == MessageType.DATA || message.type() == MessageType.ACK;
  }

  private RecordedMessage message(PlayerMessage message) {
    String device = layouts.nameOf(message.device());
    String type = device.substring(0, device.indexOf(':')) + "/"
        + layouts.of(message).map(known -> known.name()).orElse(Integer.toString(message.subtype()));
    Map<String, String> metadata =
        message.type() == MessageType.ACK ? Map.of(MESSAGE, ANSWER, "latching", "1") : Map.of();
    return channels.raw("/" + device, new RecordedSchema(type, "", new byte[0]), ENCODING, metadata,
        message.payload(), PlayerLines.moment(message.stamp()));
  }
}
