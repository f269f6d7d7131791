package org.robotui.rfic.recording.internal.send;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robotui.player.layout.InterfaceLayout;
import org.robotui.player.layout.Layouts;
import org.robotui.player.layout.MessageLayout;
import org.robotui.player.server.Answer;
import org.robotui.player.server.DeviceHandler;
import org.robotui.player.server.PlayerServer;
import org.robotui.player.server.ServedDevice;
import org.robotui.player.server.ServerOptions;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerMessage;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingReader;
import org.robotui.rfic.recording.internal.lines.PlayerDeviceLines;

/**
 * The devices of one robot behind a Player server. They say what was recorded; requests get the answers that were
 * recorded, and commands change nothing.
 */
final class ReplayedRobot implements AutoCloseable {
  private static final Pattern DEVICE = Pattern.compile("/?(\\w+):(\\d{1,9})");
  private static final String DRIVER = "robotui";
  private static final double NANOS = 1e9;

  /** What a channel is of. */
  private record Kind(Device device, boolean isAnswer, int subtype) {}

  /** A device with what it was heard to answer, by requests. */
  private record Device(ServedDevice served, Map<Integer, ByteBuffer> answers) {}

  private final Layouts layouts;
  private final PlayerServer server;
  private final Map<String, Device> devices = new TreeMap<>();
  private final Map<Integer, Kind> kinds = new HashMap<>();

  private ReplayedRobot(Layouts layouts, PlayerServer server) {
    this.layouts = layouts;
    this.server = server;
  }

  static ReplayedRobot open(Layouts layouts, ServerOptions options) throws IOException {
    return new ReplayedRobot(layouts, new PlayerServer(layouts, options));
  }

  /** Adds the devices that channels are of. Clients may ask at once, so the first of all answers holds from now on. */
  void add(RecordingReader recording, List<RecordedChannel> channels) throws IOException {
    for (RecordedChannel each : channels) {
      Kind kind = kind(each);
      kinds.put(each.id(), kind);
      if (kind.isAnswer()) {
        recording.cursor(RecordingInterval.ALWAYS, Set.of(each.id())).next().ifPresent(this::publish);
      }
    }
  }

  private Kind kind(RecordedChannel channel) throws IOException {
    Matcher name = DEVICE.matcher(channel.topic());
    Optional<InterfaceLayout> known = name.matches() ? layouts.byName(name.group(1)) : Optional.empty();
    String type = channel.schema().name().isEmpty() ? channel.metadata().getOrDefault("robotui.type", "")
        : channel.schema().name();
    boolean isAnswer = PlayerDeviceLines.isAnswer(channel);
    MessageType of = isAnswer ? MessageType.REQUEST : MessageType.DATA;
    Optional<Integer> subtype = known.flatMap(each -> subtype(each, of, type.substring(type.indexOf('/') + 1)));
    if (subtype.isEmpty()) {
      throw new IOException(channel.topic() + ": '" + type
          + "' is no message of a device of Player, such as laser/scan of laser:0: choose other topics by --topics");
    }
    return new Kind(device(name.group(1), Integer.parseInt(name.group(2))), isAnswer, subtype.get());
  }

  /** A message that was not known had its number as its name. */
  private static Optional<Integer> subtype(InterfaceLayout layout, MessageType type, String message) {
    return message.matches("\\d{1,3}") ? Optional.of(Integer.parseInt(message))
        : layout.message(type, message).map(MessageLayout::subtype);
  }

  private Device device(String kind, int index) {
    return devices.computeIfAbsent(kind + ":" + index, name -> {
      Map<Integer, ByteBuffer> answers = new ConcurrentHashMap<>();
      return new Device(server.add(kind, index, DRIVER, new Recorded(answers)), answers);
    });
  }

  /** What a device does that is none. */
  private record Recorded(Map<Integer, ByteBuffer> answers) implements DeviceHandler {
    @Override
    public void onCommand(PlayerMessage command) {
      // what was recorded does not move otherwise
    }

    @Override
    public Answer onRequest(PlayerMessage request) {
      ByteBuffer answer = answers.get(request.subtype());
      return answer == null ? Answer.refused() : new Answer.Ack(answer.duplicate());
    }
  }

  void publish(RecordedMessage message) {
    Kind kind = kinds.get(message.channel().id());
    ByteBuffer data = FrameworkSender.copy(message.data());
    if (kind.isAnswer()) {
      kind.device().answers().put(kind.subtype(), data);
    } else {
      kind.device().served().publish(kind.subtype(), data, message.publishTime() / NANOS);
    }
  }

  int port() {
    return server.port();
  }

  Set<String> devices() {
    return devices.keySet();
  }

  boolean isHeard() {
    return devices.values().stream().allMatch(each -> each.served().clients() > 0);
  }

  void awaitSent(Duration patience) throws InterruptedException {
    server.awaitSent(patience);
  }

  @Override
  public void close() {
    server.close();
  }
}
