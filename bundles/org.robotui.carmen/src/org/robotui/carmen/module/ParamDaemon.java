package org.robotui.carmen.module;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.DoubleSupplier;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.message.IpcRecordMaker;

/** A parameter daemon as CARMEN has one, for simulated robots and tests. Safe for all threads. */
public final class ParamDaemon {

  private static final int ALL = 100;
  private static final int ABSENT = 1;
  private static final int MINOR = 8;

  private final IpcForms forms;
  private final DoubleSupplier clock;
  private final String host;
  private final MessageSender change;
  private final Map<String, Map<String, String>> values = new TreeMap<>(); // guarded by this

  /**
   * Answers from now on.
   *
   * @param module that is linked
   * @param forms of CARMEN
   * @param clock the time, seconds
   * @param host whose answers they are
   * @param initial the settings of each program
   * @throws IOException where the central does not answer
   */
  public ParamDaemon(IpcModule module, IpcForms forms, DoubleSupplier clock, String host,
      Map<String, Map<String, String>> initial) throws IOException {
    this.forms = forms;
    this.clock = clock;
    this.host = host;
    initial.forEach((name, settings) -> values.put(name, new TreeMap<>(settings)));
    this.change = module.sender(forms.get("carmen_param_variable_change"));
    for (String kind : List.of("int", "double", "onoff", "string")) {
      answer(module, "carmen_param_query_" + kind, asked -> value(kind, asked));
    }
    answer(module, "carmen_param_query_version", asked -> forms.get("carmen_param_version").make()
        .number("minor", MINOR));
    answer(module, "carmen_param_query_modules", asked -> modules());
    answer(module, "carmen_param_query_all", this::all);
    answer(module, "carmen_param_set", this::set);
  }

  private interface Answering {
    IpcRecordMaker answer(IpcRecord asked);
  }

  private void answer(IpcModule module, String question, Answering answering) throws IOException {
    module.subscribe(forms.get(question), ALL, (IpcRecord asked, ByteBuffer body) -> {
      IpcRecordMaker made = answering.answer(asked);
      IpcRecord record = made.number("timestamp", clock.getAsDouble()).text("host", host).build();
      return Optional.of(new IpcAnswer(made.form(), record));
    });
  }

  private synchronized Optional<String> find(IpcRecord asked) {
    return Optional.ofNullable(values.getOrDefault(asked.text("module_name"), Map.of())
        .get(asked.text("variable_name")));
  }

  private IpcRecordMaker value(String kind, IpcRecord asked) {
    Optional<String> found = find(asked);
    IpcRecordMaker answer =
        named("carmen_param_respond_" + kind, asked).number("status", found.isPresent() ? 0 : ABSENT);
    String text = found.orElse("");
    return kind.equals("string") ? answer.text("value", text) : answer.number("value", number(text));
  }

  private static double number(String text) {
    try {
      return text.equals("on") ? 1 : Double.parseDouble(text);
    } catch (NumberFormatException e) {
      return 0;
    }
  }

  private IpcRecordMaker named(String message, IpcRecord asked) {
    return forms.get(message).make().text("module_name", asked.text("module_name"))
        .text("variable_name", asked.text("variable_name"));
  }

  private synchronized IpcRecordMaker modules() {
    return forms.get("carmen_param_respond_modules").make().texts("modules", List.copyOf(values.keySet()));
  }

  private synchronized IpcRecordMaker all(IpcRecord asked) {
    Map<String, String> settings = values.getOrDefault(asked.text("module_name"), Map.of());
    return forms.get("carmen_param_respond_all").make().text("module_name", asked.text("module_name"))
        .texts("variables", List.copyOf(settings.keySet())).texts("values", List.copyOf(settings.values()))
        .wholes("expert", new int[settings.size()]).number("status", settings.isEmpty() ? ABSENT : 0);
  }

  /** Tells all who listen what was changed. */
  private synchronized IpcRecordMaker set(IpcRecord asked) {
    boolean known = find(asked).isPresent();
    if (known) {
      values.get(asked.text("module_name")).put(asked.text("variable_name"), asked.text("value"));
      change.publish(named("carmen_param_variable_change", asked).text("value", asked.text("value"))
          .number("timestamp", clock.getAsDouble()).text("host", host).build());
    }
    return named("carmen_param_respond_string", asked).text("value", find(asked).orElse(""))
        .number("status", known ? 0 : ABSENT);
  }

  /**
   * A setting.
   *
   * @param of the program
   * @param variable the setting
   * @return its value; empty where there is none
   */
  public synchronized Optional<String> get(String of, String variable) {
    return Optional.ofNullable(values.getOrDefault(of, Map.of()).get(variable));
  }
}
