package org.robotui.player.log;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robotui.player.layout.InterfaceLayout;
import org.robotui.player.layout.Layouts;
import org.robotui.player.layout.MessageLayout;
import org.robotui.player.layout.PlayerRecord;
import org.robotui.player.layout.StructLayout;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

/** Messages as lines of log files, and back. Immutable; any thread may use it. */
public final class LogFormat {

  private static final Pattern LINE = Pattern.compile("(\\w+) (\\w+) (\\d+): (.*)");
  /** The words that begin every line: time, host, robot, interface, index, type, subtype. */
  private static final int HEAD = 7;
  private static final int TYPE = 5;

  private record Key(String on, MessageType type, int subtype) {}

  private final Layouts layouts;
  private final Map<Key, LineLayout> lines = new HashMap<>();

  /**
   * Creates the format.
   *
   * @param layouts the interfaces that are known
   */
  public LogFormat(Layouts layouts) {
    this.layouts = layouts;
    text().lines().map(LINE::matcher).filter(Matcher::matches).forEach(line -> lines.put(
        new Key(line.group(1), MessageType.valueOf(line.group(2).toUpperCase(Locale.ROOT)),
            Integer.parseInt(line.group(3))),
        LineLayout.parse(line.group(4))));
  }

  private static String text() {
    try (InputStream in = LogFormat.class.getResourceAsStream("lines")) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Writes a message.
   *
   * @param message the message
   * @return its line without an end; empty if log files have no line for such messages
   * @throws PlayerException if the message's body is not valid
   */
  public Optional<String> line(PlayerMessage message) throws PlayerException {
    DeviceAddress device = message.device();
    String on = layouts.byCode(device.interfaceCode()).map(InterfaceLayout::name).orElse("");
    LineLayout line = lines.get(new Key(on, message.type(), message.subtype()));
    if (line == null) {
      return Optional.empty();
    }
    PlayerRecord record = layouts.decode(message);
    return Optional.of(
        String.format(Locale.ROOT, "%s %d %d %s %02d %03d %03d %s", NumberFormat.of("%014.3f").write(message.stamp()),
            Integer.toUnsignedLong(device.host()), Integer.toUnsignedLong(device.robot()), on, device.index(),
            message.type().code(),
            message.subtype(), LineWriter.write(line, record)));
  }

  /**
   * Reads a line.
   *
   * @param line the line without its end
   * @return the message; empty if nothing is known of its body
   * @throws PlayerException if it is no line of a log file
   */
  public Optional<PlayerMessage> message(String line) throws PlayerException {
    String[] words = line.strip().split("\\s+");
    if (words.length < HEAD) {
      throw new PlayerException("the line ends too early");
    }
    try {
      return message(words);
    } catch (IllegalArgumentException e) {
      throw new PlayerException("the line is not understood: " + e.getMessage());
    }
  }

  private Optional<PlayerMessage> message(String[] words) throws PlayerException {
    InterfaceLayout known =
        layouts.byName(words[3]).orElseThrow(() -> new PlayerException("there is no interface '" + words[3] + "'"));
    DeviceAddress device =
        new DeviceAddress(Integer.parseUnsignedInt(words[1]), Integer.parseUnsignedInt(words[2]), known.code(),
            Integer.parseInt(words[4]));
    MessageType type = MessageType.of(Integer.parseInt(words[TYPE]))
        .orElseThrow(() -> new PlayerException("there is no message type " + words[TYPE]));
    int subtype = Integer.parseInt(words[HEAD - 1]);
    LineLayout line = lines.get(new Key(known.name(), type, subtype));
    Optional<StructLayout> struct = known.message(type, subtype)
        .flatMap(type == MessageType.ACK ? MessageLayout::answer : MessageLayout::payload);
    if (line == null || struct.isEmpty()) {
      return Optional.empty();
    }
    PlayerRecord record = LineReader.read(line, struct.get(), words, HEAD);
    return Optional
        .of(PlayerMessage.of(device, type, subtype, layouts.encode(record)).withStamp(NumberFormat.read(words[0])));
  }
}
