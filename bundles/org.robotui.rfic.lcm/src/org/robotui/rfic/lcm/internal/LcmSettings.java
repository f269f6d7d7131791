package org.robotui.rfic.lcm.internal;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.lcm.LcmUrl;
import org.robotui.rfic.lcm.internal.convert.CommandForm;
import org.robotui.rfic.lcm.internal.convert.Shape;
import org.robotui.rfic.lcm.internal.language.Mapping;

/**
 * How a robot that speaks LCM is reached, and what its messages mean.
 *
 * @param url where its messages come from
 * @param types where its types are declared: files and folders
 * @param streams which channels become which data
 * @param commands which commands go to which channel
 * @param guard whether a process of its own keeps the connection
 */
public record LcmSettings(LcmUrl url, List<Path> types, List<Stream> streams, List<Command> commands, boolean guard) {
  private static final ValueType TEXT = new ValueType.Text();
  private static final ValueType TEXTS = new ValueType.AnyOf(List.of(TEXT, new ValueType.ListOf(TEXT)));
  private static final ValueType FIELD =
      new ValueType.WithPlace(
          new ValueType.AnyOf(List.of(TEXT, new ValueType.ListOf(TEXT), new ValueType.MapOf(TEXT))));
  private static final ValueType FIELDS = new ValueType.MapOf(FIELD);
  private static final ValueType MAPPING = new ValueType.WithPlace(new ValueType.AnyOf(List.of(TEXT, FIELDS)));

  static final Schema SCHEMA = Schema.of(
      Setting.optional("url", new ValueType.WithPlace(TEXT),
          "where the messages come from, for example udpm://239.255.76.67:7667?ttl=1, "
              + "tcpq://host:7700 or file://recorded.lcmlog; else LCM_DEFAULT_URL"),
      Setting.optional("types", new ValueType.WithPlace(TEXTS),
          "files and folders of .lcm files, relative to this file"),
      Setting.of("channels", new ValueType.MapOf(new ValueType.AnyOf(List.of(MAPPING, new ValueType.ListOf(MAPPING)))),
          Map.of(),
          "what the messages of channels become; others become records with the fields of their type"),
      Setting.of("commands", new ValueType.MapOf(MAPPING), Map.of(), "which channels take which commands"),
      Setting.optional("guard", new ValueType.WithPlace(new ValueType.Flag()),
          "for tcpq: keeps the connection in a small process of its own, "
              + "so that the server never waits for a workbench that is stopped or killed"));

  /**
   * A channel whose messages become data.
   *
   * @param mapping which members are which fields
   * @param shape the data
   * @param port the name of its port
   * @param type the type of its messages, where it is written
   */
  public record Stream(Mapping mapping, Shape<?> shape, String port, Optional<Placed> type) {}

  /**
   * A channel that takes commands.
   *
   * @param mapping which fields go to which members
   * @param form the kind of commands
   * @param type the type of its messages
   * @param fixed members that are always the same
   */
  public record Command(Mapping mapping, CommandForm<?> form, Placed type, Placed fixed) {}

  /** Copies the lists. */
  public LcmSettings {
    types = List.copyOf(types);
    streams = List.copyOf(streams);
    commands = List.copyOf(commands);
  }
}
