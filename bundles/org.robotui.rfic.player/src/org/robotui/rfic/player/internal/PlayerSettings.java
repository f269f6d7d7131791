package org.robotui.rfic.player.internal;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.rfic.player.internal.convert.FrameNames;
import org.robotui.rfic.player.internal.convert.Sonars;
import org.robotui.rfic.player.internal.link.Stamps;

/**
 * How a Player server is reached and what of it is used.
 *
 * @param host the server's name or address
 * @param port the server's port
 * @param pull how often data are fetched; if empty the server sends them as they come
 * @param newestOnly whether the server keeps only the newest of like data while they wait
 * @param key what a server with a key wants to hear, at most 32 bytes
 * @param devices only devices of these names are used
 * @param base the device whose odometry moves the robot's base, else the first position2d or position3d
 * @param frames how frames are called
 * @param sonars what Player does not tell of sonars
 * @param clock whose clock the server's stamps are of
 * @param guard whether a process of its own keeps the connection
 */
public record PlayerSettings(
    String host,
    int port,
    Optional<Duration> pull,
    boolean newestOnly,
    Optional<byte[]> key,
    List<Pattern> devices,
    Optional<String> base,
    FrameNames.Names frames,
    Sonars.Beam sonars,
    Stamps.Kind clock,
    boolean guard) {
  private static final String LOCAL = "localhost";
  private static final int PORT = 6665;
  private static final int LAST_PORT = 0xffff;
  private static final int KEY_BYTES = 32;
  private static final ValueType FRAME = new ValueType.Text(TextRule.FRAME);
  private static final TextRule KEY = TextRule.readBy("a key", PlayerSettings::key);
  private static final TextRule DEVICE =
      TextRule.matching("a device, such as position2d:0", "[a-z][a-z0-9_]{0,63}:[0-9]{1,5}");
  private static final ValueType DEVICES =
      new ValueType.Text(
          TextRule.matching("a device, such as position2d:0, in which * stands for any part", "[a-z0-9_:*]{1,99}"));

  static final Schema SCHEMA = Schema.of(
      Setting.optional("host", new ValueType.Text(TextRule.HOST),
          "name or address of the server; else PLAYER_HOST, else localhost"),
      Setting.optional("port", new ValueType.Int(1, LAST_PORT), "port of the server; else PLAYER_PORT, else 6665"),
      Setting.of("data", new ValueType.Choice(List.of("push", "pull")), "push",
          "push: the server sends data as they come; pull: they are fetched, rate times a second"),
      Setting.of("rate", new ValueType.Num(0.1, 200, "Hz"), 10.0, "how often data are fetched, where they are"),
      Setting.optional("replace", new ValueType.Flag(),
          "whether the server keeps only the newest of like data while they wait; if not written, it does where data are fetched"),
      Setting.optional("key", new ValueType.Text(KEY), "the key of a server that wants one, at most 32 bytes"),
      Setting.of("devices", new ValueType.AnyOf(List.of(DEVICES, new ValueType.ListOf(DEVICES))), List.of("*"),
          "which devices become ports, for example position2d:0; * stands for any part of a name"),
      Setting.optional("base", new ValueType.Text(DEVICE),
          "the device whose odometry moves the base; else the first position2d, else the first position3d"),
      Setting.of("base_frame", FRAME, "base_link", "name of the frame of the robot's base"),
      Setting.of("odom_frame", FRAME, "odom",
          "name of the frame of its odometry; where odometry is true on the map: map"),
      Setting.of("map_frame", FRAME, "map", "name of the frame of maps, plans and localisation"),
      Setting.of("sonar_cone", new ValueType.Num(0, Math.PI, "rad"), 0.26,
          "opening angle of sonars, which the interface sonar does not tell"),
      Setting.of("sonar_range", new ValueType.Num(0, 1000, "m"), 5.0,
          "how far sonars see, which the interface sonar does not tell"),
      Setting.of("clock", new ValueType.Choice(List.of("auto", "robot", "simulated")), "auto",
          "whose time the server's stamps are; auto: that of a robot if they are after 2001, else simulated"),
      Setting.of("guard", new ValueType.Flag(), false,
          "keeps connections in a small process of its own, so that the robot never waits for a workbench that is stopped or killed"));

  static PlayerSettings of(Settings settings, Map<String, String> variables) {
    boolean pull = settings.text("data").equals("pull");
    return new PlayerSettings(
        settings.has("host") ? settings.text("host") : given(variables, "PLAYER_HOST").orElse(LOCAL),
        settings.has("port") ? (int) settings.integer("port")
            : given(variables, "PLAYER_PORT").map(PlayerSettings::port).orElse(PORT),
        pull ? Optional.of(Duration.ofNanos(Math.round(1e9 / settings.number("rate")))) : Optional.empty(),
        settings.has("replace") ? settings.flag("replace") : pull,
        settings.has("key") ? Optional.of(key(settings.text("key"))) : Optional.empty(),
        patterns(settings),
        settings.has("base") ? Optional.of(settings.text("base")) : Optional.empty(),
        new FrameNames.Names(settings.text("base_frame"), settings.text("odom_frame"), settings.text("map_frame")),
        new Sonars.Beam(settings.number("sonar_cone"), settings.number("sonar_range")),
        Stamps.Kind.of(settings.text("clock")),
        settings.flag("guard"));
  }

  /**
   * The server as people write it.
   *
   * @return host and port
   */
  public String peer() {
    return host + ":" + port;
  }

  /**
   * Whether a device shall be used.
   *
   * @param device its name, such as {@code laser:0}
   * @return true where it is included
   */
  public boolean uses(String device) {
    return devices.stream().anyMatch(p -> p.matcher(device).matches());
  }

  private static Optional<String> given(Map<String, String> variables, String name) {
    return Optional.ofNullable(variables.get(name)).map(String::strip).filter(v -> !v.isEmpty());
  }

  private static int port(String written) {
    try {
      int port = Integer.parseInt(written);
      if (port >= 1 && port <= LAST_PORT) {
        return port;
      }
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("PLAYER_PORT is '" + written + "'; write a port from 1 to 65535", e);
    }
    throw new IllegalArgumentException("PLAYER_PORT is " + written + "; write a port from 1 to 65535");
  }

  private static byte[] key(String written) {
    byte[] bytes = written.getBytes(StandardCharsets.UTF_8);
    if (bytes.length > KEY_BYTES) {
      throw new IllegalArgumentException("key: Player's keys have at most 32 bytes, this one has " + bytes.length);
    }
    return bytes;
  }

  private static List<Pattern> patterns(Settings settings) {
    List<String> globs = settings.values().get("devices") instanceof List<?> list
        ? list.stream().map(Object::toString).toList()
        : List.of(settings.text("devices"));
    return globs.stream().map(PlayerSettings::pattern).toList();
  }

  private static Pattern pattern(String glob) {
    StringBuilder regex = new StringBuilder();
    for (String part : glob.split("\\*", -1)) {
      regex.append(regex.isEmpty() ? "" : ".*").append(Pattern.quote(part));
    }
    return Pattern.compile(regex.toString());
  }
}
