package org.robotui.condition;

import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Predicate;
import org.robotui.api.port.Input;
import org.robotui.data.record.FieldPath;

/** A part of a combined condition. */
interface Term {
  /** What it comes to now. */
  Operand value(Look look);

  /** Which streams it must be given. */
  default Predicate<Input.Candidate> needs() {
    return candidate -> false;
  }

  /** What is known of it before any robot is asked. */
  default Yields yields() {
    return Yields.NUMBER;
  }

  /** What values may be. */
  enum Yields {
    NUMBER, WORD, TRUTH, ANY
  }

  /** Something that is written. */
  record Written(Operand operand) implements Term {
    @Override
    public Operand value(Look look) {
      return operand;
    }

    @Override
    public Yields yields() {
      return operand instanceof Operand.Word ? Yields.WORD
          : operand instanceof Operand.Truth ? Yields.TRUTH : Yields.NUMBER;
    }
  }

  /** A field of what a source sends. */
  record Field(SourceName source, FieldPath path) implements Term {
    @Override
    public Operand value(Look look) {
      Operand found = new Operand.Missing("nothing called '" + source.text() + "' is offered", false);
      for (Signals.Reading reading : look.signals().readings(source)) {
        found = FieldLookup.of(reading, path);
        if (!(found instanceof Operand.Missing)) {
          look.seen().put(reading.name() + "." + path, found.text());
          return found;
        }
      }
      return found;
    }

    @Override
    public Predicate<Input.Candidate> needs() {
      return candidate -> source.fits(candidate.id());
    }

    @Override
    public Yields yields() {
      return Yields.ANY;
    }
  }

  /** Two numbers become one. */
  record Binary(DoubleBinaryOperator operator, Term left, Term right) implements Term {
    @Override
    public Operand value(Look look) {
      Operand one = left.value(look);
      Operand other = right.value(look);
      if (one instanceof Operand.Number a && other instanceof Operand.Number b) {
        return Operand.Number.of(operator.applyAsDouble(a.value(), b.value()));
      }
      return one instanceof Operand.Number ? notA(other) : notA(one);
    }

    private static Operand notA(Operand found) {
      return found instanceof Operand.Missing ? found
          : new Operand.Missing("one counts with numbers only, and '" + found.text() + "' is none", true);
    }

    @Override
    public Predicate<Input.Candidate> needs() {
      return left.needs().or(right.needs());
    }
  }

  /** One number becomes another. */
  record Unary(DoubleUnaryOperator operator, Term of) implements Term {
    @Override
    public Operand value(Look look) {
      Operand found = of.value(look);
      return found instanceof Operand.Number n ? Operand.Number.of(operator.applyAsDouble(n.value()))
          : Binary.notA(found);
    }

    @Override
    public Predicate<Input.Candidate> needs() {
      return of.needs();
    }
  }
}
