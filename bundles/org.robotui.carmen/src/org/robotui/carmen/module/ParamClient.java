package org.robotui.carmen.module;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.message.IpcRecordMaker;
import org.robotui.net.call.Outcome;

/** Asks CARMEN's parameter daemon. All of it blocks. Safe for all threads. */
public final class ParamClient {

  private static final double MILLIS = 1e3;
  private static final Duration PATIENCE = Duration.ofSeconds(3);
  private static final int OK = 0;

  private final IpcModule module;
  private final IpcForms forms;
  private final Map<String, MessageSender> senders = new ConcurrentHashMap<>();

  /**
   * Asks through a module.
   *
   * @param module that is linked
   * @param forms of CARMEN
   */
  public ParamClient(IpcModule module, IpcForms forms) {
    this.module = module;
    this.forms = forms;
  }

  /**
   * The programs that have settings, and the robot's own name for them.
   *
   * @return such as {@code robot}
   * @throws IOException where the daemon does not answer
   */
  public List<String> modules() throws IOException {
    return ask("carmen_param_query_modules", query("carmen_param_query_modules", "", "")).texts("modules");
  }

  /**
   * All settings of a program.
   *
   * @param of its name
   * @return names and values, as texts
   * @throws IOException where the daemon does not answer
   */
  public Map<String, String> all(String of) throws IOException {
    IpcRecord answer = ask("carmen_param_query_all", query("carmen_param_query_all", of, ""));
    List<String> names = answer.texts("variables");
    List<String> values = answer.texts("values");
    Map<String, String> all = new TreeMap<>();
    for (int i = 0; i < Math.min(names.size(), values.size()); i++) {
      all.put(names.get(i), values.get(i));
    }
    return all;
  }

  /**
   * A setting.
   *
   * @param of the program
   * @param variable the setting
   * @return its value; empty where there is none
   * @throws IOException where the daemon does not answer
   */
  public Optional<String> get(String of, String variable) throws IOException {
    IpcRecord answer = ask("carmen_param_query_string", query("carmen_param_query_string", of, variable));
    return answer.whole("status") == OK ? Optional.of(answer.text("value")) : Optional.empty();
  }

  /**
   * Sets a value.
   *
   * @param of the program
   * @param variable the setting
   * @param value as a text
   * @return what the daemon says it is then; empty where there is no such setting
   * @throws IOException where the daemon does not answer
   */
  public Optional<String> set(String of, String variable, String value) throws IOException {
    IpcRecord answer = ask("carmen_param_set", query("carmen_param_set", of, variable).text("value", value));
    return answer.whole("status") == OK ? Optional.of(answer.text("value")) : Optional.empty();
  }

  private IpcRecordMaker query(String message, String of, String variable) {
    return forms.get(message).make().text("module_name", of).text("variable_name", variable);
  }

  private IpcRecord ask(String message, IpcRecordMaker question) throws IOException {
    MessageSender sender = senders.get(message);
    if (sender == null) {
      sender = module.sender(forms.get(message));
      senders.put(message, sender);
    }
    IpcRecord record =
        question.number("timestamp", System.currentTimeMillis() / MILLIS).text("host", module.name()).build();
    Outcome<IpcAnswer> outcome = sender.query(record, PATIENCE);
    return outcome.toOptional().map(IpcAnswer::record).orElseThrow(() -> new IOException(outcome.reason()));
  }
}
