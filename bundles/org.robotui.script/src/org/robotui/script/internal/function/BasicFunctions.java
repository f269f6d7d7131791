package org.robotui.script.internal.function;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.script.ScriptCall;
import org.robotui.api.script.ScriptFailure;
import org.robotui.api.script.ScriptFunction;
import org.robotui.data.record.TypeDoc;
import org.robotui.script.internal.engine.ExitWish;
import org.robotui.script.internal.engine.PlainText;

/** Saying something, waiting, help, the end. */
final class BasicFunctions {
  /** What is higher may mean something to who starts the process, such as that it is to be started again. */
  private static final int MOST_CODE = 20;

  private final Supplier<List<ScriptFunction>> all;

  BasicFunctions(Supplier<List<ScriptFunction>> all) {
    this.all = all;
  }

  List<ScriptFunction> functions() {
    return List.of(
        ScriptFunction.of("print(value?, second?, third?, fourth?)", "Says values where the script was started.", "",
            BasicFunctions::print),
        ScriptFunction.of("sleep(seconds)", "Waits.", "", call -> {
          call.pause(call.seconds(0, 0));
          return null;
        }),
        ScriptFunction.of("exit(code?)", "Ends the script, and RobotUI where the script was given to ./robotui run.",
            "nothing: it does not come back", BasicFunctions::exit),
        ScriptFunction.of("help(name?)",
            "Says what a function does, or which there are; of a type of data, its fields and their units.", "",
            this::help));
  }

  private static Object print(ScriptCall call) {
    List<String> words = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      call.argument(i).map(v -> v instanceof String text ? text : PlainText.of(v)).ifPresent(words::add);
    }
    call.print(String.join(" ", words));
    return null;
  }

  private static Object exit(ScriptCall call) throws ScriptFailure {
    double code = call.number(0, 0);
    if (code != Math.rint(code) || code < 0 || code > MOST_CODE) {
      throw new ScriptFailure(
          "exit(code): the code must be a whole number from 0 to " + MOST_CODE + ", not " + PlainText.of(code));
    }
    throw new ExitWish((int) code);
  }

  private Object help(ScriptCall call) throws ScriptFailure {
    Optional<String> name = call.textIf(0);
    if (name.isEmpty()) {
      all.get().forEach(f -> call.print(f.signature() + "\n    " + f.help()));
      return null;
    }
    Optional<ScriptFunction> function = all.get().stream().filter(f -> f.name().equals(name.get())).findFirst();
    List<TypeDoc> types = TypeDoc.find(name.get());
    if (function.isEmpty() && types.isEmpty()) {
      throw new ScriptFailure("there is no function and no type of data '" + name.get() + "'; help() lists functions");
    }
    function.ifPresent(f -> call.print(f.signature() + "\n    " + f.help()
        + (f.returns().isEmpty() ? "" : "\n    Gives " + f.returns() + ".")));
    types.forEach(type -> call.print(type.name() + ": " + type.text()
        + String.join("", type.fields().stream().map(f -> "\n    " + f.name() + " (" + f.type() + "): " + f.text())
            .toList())));
    return null;
  }
}
