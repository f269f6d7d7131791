package org.robotui.condition;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Predicate;
import org.robotui.api.port.Input;

/**
 * A condition that combines several.
 *
 * @param claim what must hold
 * @param slack by how much numbers must come back for the alert to end
 */
record ExpressionCondition(Term claim, double slack) implements Condition {
  @Override
  public Verdict check(Signals signals, boolean active) {
    Map<String, String> seen = new LinkedHashMap<>();
    return switch (Claim.truth(claim.value(new Look(signals, active, slack, seen)))) {
      case Operand.Truth t when t.value() -> new Verdict.Holds(String.join(", ", seen.keySet()),
          seen.size() == 1 ? "is" : "are", String.join(", ", seen.values()));
      case Operand.Missing m -> new Verdict.Unknown(m.reason(), m.wrong());
      default -> new Verdict.Fails();
    };
  }

  @Override
  public Predicate<Input.Candidate> needs() {
    return claim.needs();
  }
}
