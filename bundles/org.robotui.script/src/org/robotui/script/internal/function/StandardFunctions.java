package org.robotui.script.internal.function;

import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.robotui.api.script.ScriptFunction;

/** What scripts can call without any other bundle. */
public final class StandardFunctions {
  private StandardFunctions() {}

  /** All of them; help tells of those that are given here, too. */
  public static List<ScriptFunction> all(Supplier<List<ScriptFunction>> known) {
    return Stream.of(new BasicFunctions(known).functions(), UiFunctions.functions(), ViewFunctions.functions(),
        PortFunctions.functions(), CommandFunctions.functions(), CallFunctions.functions(), AlertFunctions.functions())
        .flatMap(List::stream).toList();
  }
}
