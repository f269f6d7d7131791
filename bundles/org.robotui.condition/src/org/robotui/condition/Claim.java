package org.robotui.condition;

import java.util.Optional;
import java.util.function.Predicate;
import org.robotui.api.port.Input;

/**
 * A part of a combined condition that holds or does not. What cannot be told leaves open what depends on it, no more.
 */
interface Claim extends Term {
  @Override
  default Yields yields() {
    return Yields.TRUTH;
  }

  /** Two values are compared. */
  record Compared(Comparison comparison, Term left, Term right) implements Claim {
    @Override
    public Operand value(Look look) {
      Operand one = left.value(look);
      Operand other = right.value(look);
      return missing(one).or(() -> missing(other)).orElseGet(() -> compare(one, other, look));
    }

    private static Optional<Operand> missing(Operand found) {
      return Optional.of(found).filter(Operand.Missing.class::isInstance);
    }

    private Operand compare(Operand one, Operand other, Look look) {
      if (one instanceof Operand.Number a && other instanceof Operand.Number b) {
        return new Operand.Truth(comparison.holds(a.value(), b.value(), look.active() ? look.slack() : 0));
      }
      String left = one.text();
      String right = other.text();
      if (comparison.ordered() || one instanceof Operand.Number || other instanceof Operand.Number) {
        return new Operand.Missing("'" + left + "' and '" + right + "' cannot be compared by " + comparison.sign()
            + "; numbers can, and words by == and !=", true);
      }
      return new Operand.Truth(comparison.holds(left, right));
    }

    @Override
    public Predicate<Input.Candidate> needs() {
      return left.needs().or(right.needs());
    }
  }

  /** Two claims: both must hold, or one. */
  record Both(boolean all, Term left, Term right) implements Claim {
    @Override
    public Operand value(Look look) {
      Operand one = left.value(look);
      Operand other = right.value(look);
      if (decides(one) || decides(other)) {
        return new Operand.Truth(!all);
      }
      return one instanceof Operand.Truth ? truth(other) : truth(one);
    }

    /** One that does not hold ends a conjunction, and one that holds ends a disjunction. */
    private boolean decides(Operand found) {
      return found instanceof Operand.Truth t && t.value() != all;
    }

    @Override
    public Predicate<Input.Candidate> needs() {
      return left.needs().or(right.needs());
    }
  }

  /** A claim must not hold. */
  record Turned(Term of) implements Claim {
    @Override
    public Operand value(Look look) {
      Operand found = truth(of.value(look.turned()));
      return found instanceof Operand.Truth t ? new Operand.Truth(!t.value()) : found;
    }

    @Override
    public Predicate<Input.Candidate> needs() {
      return of.needs();
    }
  }

  /** One of the plain conditions. */
  record Plain(Condition condition) implements Claim {
    @Override
    public Operand value(Look look) {
      return switch (condition.check(look.signals(), look.active())) {
        case Verdict.Holds h -> {
          look.seen().put(h.source(), h.value());
          yield new Operand.Truth(true);
        }
        case Verdict.Fails f -> new Operand.Truth(false);
        case Verdict.Unknown u -> new Operand.Missing(u.reason(), u.wrong());
      };
    }

    @Override
    public Predicate<Input.Candidate> needs() {
      return condition.needs();
    }
  }

  /** What a field must be that stands for a claim. */
  static Operand truth(Operand found) {
    return switch (found) {
      case Operand.Truth t -> t;
      case Operand.Missing m -> m;
      case Operand.Number n -> new Operand.Missing("a number, " + n.text() + ", is not true or false; compare it",
          true);
      case Operand.Word w -> new Operand.Missing("'" + w.text() + "' is not true or false; compare it by ==", true);
    };
  }
}
