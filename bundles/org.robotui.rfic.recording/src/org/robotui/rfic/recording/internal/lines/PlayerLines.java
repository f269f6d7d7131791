package org.robotui.rfic.recording.internal.lines;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.geometry.RigidTransform;
import org.robotui.player.layout.FieldLayout;
import org.robotui.player.layout.FieldValue;
import org.robotui.player.layout.Layouts;
import org.robotui.player.layout.PlayerRecord;
import org.robotui.player.log.LogFormat;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.rfic.recording.internal.lines.LineChannels.Moment;

/** Lines of Player's driver writelog. Topics are named as the devices of a robot that runs Player. */
final class PlayerLines implements LineFormat {
  static final String NAME = "Player log";
  private static final String HEAD = "## Player version";
  private static final double NANOS = 1e9;
  private static final double LATEST = 9e9;
  private static final int MOST_CHARACTERS = 200;

  private final Layouts layouts = Layouts.standard();
  private final LogFormat format = new LogFormat(layouts);
  private final LineChannels channels = new LineChannels();
  private final LogLineMessages robot = new LogLineMessages(channels);
  /** The first device of a kind moves the base, as for a live robot. */
  private final Map<String, String> first = new HashMap<>();

  /** Whether a file begins so. */
  static boolean isHead(Stream<String> lines) {
    return lines.findFirst().filter(line -> line.startsWith(HEAD)).isPresent();
  }

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public List<RecordedChannel> channels() {
    return channels.all();
  }

  @Override
  public List<RecordedMessage> messages(String line) {
    Optional<PlayerMessage> message = parse(format, line);
    try {
      return message.isEmpty() ? List.of() : messages(message.get());
    } catch (PlayerException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  /** The message of a line; none for a comment. */
  static Optional<PlayerMessage> parse(LogFormat format, String line) {
    if (line.isEmpty() || line.startsWith("#")) {
      return Optional.empty();
    }
    try {
      Optional<PlayerMessage> message = format.message(line);
      if (message.isEmpty()) {
        throw new IllegalArgumentException("how its numbers follow each other is not known: "
            + line.substring(0, Math.min(line.length(), MOST_CHARACTERS)));
      }
      return message;
    } catch (PlayerException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  private List<RecordedMessage> messages(PlayerMessage message) throws PlayerException {
    PlayerRecord record = layouts.decode(message);
    Moment moment = moment(message.stamp());
    String device = layouts.nameOf(message.device());
    String kind = device.substring(0, device.indexOf(':'));
    boolean base = first.computeIfAbsent(kind, each -> device).equals(device);
    boolean data = message.type() == MessageType.DATA && message.subtype() == 1;
    boolean geometry = message.type() != MessageType.DATA;
    if (kind.equals("position2d") && data && base) {
      return robot.odometry("/" + device, pose(record, "position"), new double[]{number(record, "velocity.x"),
          number(record, "velocity.y"), number(record, "velocity.yaw")}, moment);
    }
    if (kind.equals("laser") && data) {
      return List.of(scan(device, record, moment));
    }
    if (kind.equals("laser") && geometry) {
      return List.of(robot.transform(LogLineMessages.BASE, frame(device), pose(record, "pose"), moment));
    }
    return List.of(channels.json("/" + device + (data ? ""
        : "/" + message.type().name().toLowerCase(Locale.ROOT) + "_"
            + message.subtype()),
        "player/" + kind, tree(record), moment));
  }

  static Moment moment(double seconds) {
    if (!(seconds >= 0 && seconds < LATEST)) {
      throw new IllegalArgumentException("its time is " + seconds + " s");
    }
    long nanos = Math.round(seconds * NANOS);
    return new Moment(nanos, nanos);
  }

  private static String frame(String device) {
    return device.replace(':', '_');
  }

  private static double number(PlayerRecord record, String path) {
    return record.number(path).orElseThrow(() -> new IllegalArgumentException("it has no " + path));
  }

  private static RigidTransform pose(PlayerRecord record, String of) {
    return RigidTransform.planar(number(record, of + ".x"), number(record, of + ".y"), number(record, of + ".yaw"));
  }

  private RecordedMessage scan(String device, PlayerRecord record, Moment moment) {
    float[] ranges = floats(record, "ranges");
    float[] intensities = floats(record, "intensities");
    return robot.scan("/" + device, frame(device), number(record, "min_angle"), number(record, "resolution"),
        number(record, "max_range"), ranges, intensities.length == ranges.length ? intensities : new float[0], moment);
  }

  private static float[] floats(PlayerRecord record, String name) {
    double[] values = switch (record.field(name).orElse(new FieldValue.Numbers(new double[0]))) {
      case FieldValue.Numbers numbers -> numbers.values();
      case FieldValue.Bytes bytes -> numbers(bytes.value());
      default -> new double[0];
    };
    float[] floats = new float[values.length];
    for (int i = 0; i < values.length; i++) {
      floats[i] = (float) values[i];
    }
    return floats;
  }

  private static double[] numbers(byte[] bytes) {
    double[] values = new double[bytes.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = bytes[i] & 0xff;
    }
    return values;
  }

  private static Map<String, Object> tree(PlayerRecord record) {
    Map<String, Object> tree = new LinkedHashMap<>();
    for (FieldLayout each : record.layout().fields()) {
      record.field(each.name()).ifPresent(value -> tree.put(each.name(), tree(value)));
    }
    return tree;
  }

  private static Object tree(FieldValue value) {
    return switch (value) {
      case FieldValue.Whole whole -> whole.value();
      case FieldValue.Real real -> real.value();
      case FieldValue.Flag flag -> flag.value();
      case FieldValue.Text text -> text.value();
      case FieldValue.Bytes bytes -> numbers(bytes.value());
      case FieldValue.Numbers numbers -> numbers.values();
      case FieldValue.Nested nested -> tree(nested.value());
      case FieldValue.Many many -> many.values().stream().map(PlayerLines::tree).toList();
    };
  }
}
