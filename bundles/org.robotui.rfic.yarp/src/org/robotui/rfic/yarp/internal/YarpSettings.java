package org.robotui.rfic.yarp.internal;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.api.session.BaseFrames;
import org.robotui.net.socket.HostPort;
import org.robotui.rfic.yarp.internal.feed.ModelFile;
import org.robotui.rfic.yarp.internal.feed.StreamCarrier;
import org.robotui.rfic.yarp.internal.feed.YarpDevice;
import org.robotui.yarp.wire.YarpFraming;

/**
 * How a name server is reached, what is shown of its ports, and how frames are called.
 *
 * @param server where the name server listens
 * @param prefix what names of the robot's ports begin with
 * @param carrier by which ports shall say their messages
 * @param carriers by which ports shall say theirs that are named
 * @param types what ports are, where their names do not tell
 * @param frames how the frames are called that carry all others
 * @param model the file that says how the robot is built
 */
public record YarpSettings(HostPort server, String prefix, StreamCarrier carrier, Map<String, StreamCarrier> carriers,
    Map<String, YarpDevice> types, BaseFrames frames, Optional<ModelFile> model) {

  static final String URDF = "urdf";
  private static final String VARIABLE = "YARP_NAMESERVER";
  private static final int LAST_PORT = 0xffff;
  private static final TextRule PREFIX =
      TextRule.matching("what names of ports begin with, such as /icub", "(/[^\\s]{1,200})?");

  static final Schema SCHEMA = Schema.of(
      Setting.optional("host", new ValueType.Text(TextRule.HOST),
          "name or address of the name server; else that in YARP_NAMESERVER, else localhost"),
      Setting.optional("port", new ValueType.Int(1, LAST_PORT),
          "port of the name server; else that in YARP_NAMESERVER, else 10000"),
      Setting.of("prefix", new ValueType.Text(PREFIX), "",
          "what names of this robot's ports begin with, where a name server serves several robots"),
      Setting.of("carrier",
          new ValueType.Choice(StreamCarrier.words()), StreamCarrier.FAST_TCP.word(),
          "by which the robot's ports say their messages; mjpeg is for pictures only"),
      Setting.of("carriers", new ValueType.MapOf(new ValueType.Choice(StreamCarrier.words())), Map.of(),
          "by which single ports say theirs, by their names"),
      Setting.of("types", new ValueType.MapOf(new ValueType.Choice(YarpDevice.words())), Map.of(),
          "what ports are, by their names, where the names do not tell"),
      Setting.optional(URDF, new ValueType.WithPlace(new ValueType.Text()),
          "a file that says how the robot is built, relative to this file; an .srdf of the same name beside it is read, too"),
      BaseFrames.BASE, BaseFrames.ODOM, BaseFrames.MAP);

  static YarpSettings of(Settings settings, Map<String, String> variables) {
    HostPort told =
        HostPort.ofVariable(VARIABLE, variables.getOrDefault(VARIABLE, "").strip(), YarpFraming.NAME_SERVER_PORT);
    HostPort server = new HostPort(settings.has("host") ? settings.text("host") : told.host(),
        settings.has("port") ? (int) settings.integer("port") : told.port());
    Map<String, YarpDevice> types = new LinkedHashMap<>();
    settings.map("types").forEach((name, word) -> types.put(String.valueOf(name), YarpDevice.of(String.valueOf(word))));
    Map<String, StreamCarrier> carriers = new LinkedHashMap<>();
    settings.map("carriers")
        .forEach((name, word) -> carriers.put(String.valueOf(name), StreamCarrier.of(String.valueOf(word))));
    return new YarpSettings(server, settings.text("prefix"), StreamCarrier.of(settings.text("carrier")),
        Map.copyOf(carriers), Map.copyOf(types), BaseFrames.of(settings), urdf(settings).map(ModelFile::of));
  }

  static Optional<Placed> urdf(Settings settings) {
    return settings.has(URDF) ? Optional.of((Placed) settings.values().get(URDF)) : Optional.empty();
  }

  /**
   * The name server as people write it.
   *
   * @return host and port
   */
  public String peer() {
    return server.toString();
  }
}
