package org.robotui.rfic.lcm.internal;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.config.Placed;
import org.robotui.api.config.SettingFault;
import org.robotui.api.config.Settings;
import org.robotui.lcm.Lcm;
import org.robotui.lcm.LcmUrl;
import org.robotui.rfic.lcm.internal.convert.CommandForm;
import org.robotui.rfic.lcm.internal.convert.LcmShapes;
import org.robotui.rfic.lcm.internal.convert.Shape;
import org.robotui.rfic.lcm.internal.language.FaultException;
import org.robotui.rfic.lcm.internal.language.Form;
import org.robotui.rfic.lcm.internal.language.Mapping;

/** Reads settings, and collects all that is wrong with them. */
final class SettingsReader {
  private static final String AS = "as";
  private static final String TYPE = "type";
  private static final String PORT = "port";
  private static final String SET = "set";

  private final Map<String, String> variables;
  private final List<SettingFault> faults = new ArrayList<>();
  private final List<LcmSettings.Stream> streams = new ArrayList<>();
  private final List<LcmSettings.Command> commands = new ArrayList<>();
  private final Set<String> ports = new HashSet<>();

  SettingsReader(Map<String, String> variables) {
    this.variables = variables;
  }

  /** What is wrong. */
  List<SettingFault> faults() {
    return faults;
  }

  /** The settings; what is wrong with them is left out. */
  LcmSettings read(Settings settings) {
    LcmUrl url = settings.has("url") ? url((Placed) settings.values().get("url")) : standard();
    List<Path> types = settings.has("types") ? paths((Placed) settings.values().get("types")) : List.of();
    settings.map("channels").forEach((channel, written) -> {
      List<?> all = written instanceof List<?> list ? list : List.of(written);
      all.forEach(each -> attempt(() -> stream(channel.toString(), (Placed) each)));
    });
    settings.map("commands")
        .forEach((channel, written) -> attempt(() -> command(channel.toString(), (Placed) written)));
    return new LcmSettings(url, types, streams, commands,
        settings.has("guard") && guard((Placed) settings.values().get("guard"), url));
  }

  /** A part of the reading. */
  @FunctionalInterface
  private interface Attempt {
    void run() throws FaultException;
  }

  private void attempt(Attempt attempt) {
    try {
      attempt.run();
    } catch (FaultException e) {
      faults.add(e.fault());
    }
  }

  private LcmUrl standard() {
    try {
      return checked(LcmUrl.of(variables));
    } catch (IllegalArgumentException e) {
      faults.add(Placed.nowhere("").fault(e.getMessage()));
      return LcmUrl.of(LcmUrl.DEFAULT);
    }
  }

  private LcmUrl url(Placed written) {
    try {
      LcmUrl url = LcmUrl.of(written.value().toString());
      return checked(url.provider().equals("file")
          ? new LcmUrl(url.provider(), written.resolve(url.network()).toString(), url.options())
          : url);
    } catch (IllegalArgumentException e) {
      faults.add(written.fault("'url': " + e.getMessage()));
      return LcmUrl.of(LcmUrl.DEFAULT);
    }
  }

  private boolean guard(Placed written, LcmUrl url) {
    boolean wanted = written.value().equals(true);
    if (wanted && !url.provider().equals("tcpq")) {
      faults.add(written.fault("'guard' is for servers (tcpq://HOST:PORT) alone: nobody waits for who listens to " + url
          + "; leave it out"));
    }
    return wanted;
  }

  private static LcmUrl checked(LcmUrl url) {
    Lcm.check(url);
    return url;
  }

  private List<Path> paths(Placed written) {
    List<Path> paths = new ArrayList<>();
    for (Object text : written.value() instanceof List<?> list ? list : List.of(written.value())) {
      try {
        paths.add(written.resolve(text.toString()));
      } catch (InvalidPathException e) {
        faults.add(written.fault("'types': '" + text + "' is no name of a file or folder: " + e.getReason()));
      }
    }
    return paths;
  }

  private void stream(String channel, Placed written) throws FaultException {
    Map<String, Placed> entries = entries(written, "odometry");
    Placed as = word(entries, AS, written, "what the messages of " + channel + " become, one of " + LcmShapes.words());
    Shape<?> shape = LcmShapes.of(as.value().toString())
        .orElseThrow(() -> new FaultException(
            as.fault("'" + as.value() + "' is nothing that messages become; write one of " + LcmShapes.words())));
    Optional<Placed> type = Optional.ofNullable(entries.remove(TYPE));
    Placed port = Optional.ofNullable(entries.remove(PORT)).orElse(as);
    String name = port == as ? unused(channel, as.value().toString()) : port.value().toString();
    if (!ports.add(name)) {
      throw new FaultException(port.fault("the port '" + name + "' is there already; write another name after port:"));
    }
    streams.add(new LcmSettings.Stream(Mapping.parse(written, channel, shape.form(), entries), shape, name, type));
  }

  /** What is said of a channel second is named after what it becomes. */
  private String unused(String channel, String word) {
    return ports.contains(channel) ? channel + "/" + word : channel;
  }

  private void command(String channel, Placed written) throws FaultException {
    Map<String, Placed> entries = entries(written, "velocity, type: robotui.velocity_t");
    Placed as = word(entries, AS, written, "what commands " + channel + " takes, one of " + CommandForm.words());
    CommandForm<?> command = CommandForm.of(as.value().toString())
        .orElseThrow(() -> new FaultException(
            as.fault("'" + as.value() + "' is no command; write one of " + CommandForm.words())));
    Placed type =
        word(entries, TYPE, written, "the type of the messages of " + channel + ", such as robotui.velocity_t");
    Placed fixed = Optional.ofNullable(entries.remove(SET)).orElse(Placed.nowhere(Map.of()));
    if (!(fixed.value() instanceof Map<?, ?>)) {
      throw new FaultException(
          fixed.fault("'set' must be members with values, as {mode: 1}, not '" + fixed.value() + "'"));
    }
    Form form = command.form();
    commands.add(new LcmSettings.Command(Mapping.parse(written, channel, form, entries), command, type, fixed));
  }

  /** What is written; a word alone says what it becomes. */
  private static Map<String, Placed> entries(Placed written, String example) throws FaultException {
    Map<String, Placed> entries = new LinkedHashMap<>();
    if (written.value() instanceof Map<?, ?> map) {
      map.forEach((key, value) -> entries.put(key.toString(), (Placed) value));
    } else if (written.value() instanceof String word) {
      entries.put(AS, new Placed(word, written.file(), written.line(), written.column()));
    } else {
      throw new FaultException(written.fault("expected a mapping; write for example {as: " + example + "}"));
    }
    return entries;
  }

  private static Placed word(Map<String, Placed> entries, String key, Placed at, String expected)
      throws FaultException {
    Placed found = entries.remove(key);
    if (found == null) {
      throw new FaultException(at.fault("'" + key + "' is missing: " + expected));
    }
    if (!(found.value() instanceof String)) {
      throw new FaultException(found.fault("'" + key + "' must be a word: " + expected));
    }
    return found;
  }
}
