package org.robotui.testkit.rfic;

import java.util.List;
import java.util.function.Supplier;

/**
 * A part of the contract.
 *
 * @param name a sentence about the robot interface
 * @param needs without which it cannot be checked
 * @param body checks it
 */
record Clause(String name, List<Capability> needs, Body body) {
  /** Checks it with robots that it makes. */
  @FunctionalInterface
  interface Body {
    void run(Supplier<? extends Peer> peers) throws Exception;
  }

  /** Checks it with one robot interface. */
  @FunctionalInterface
  interface Part {
    void run(Trial trial) throws Exception;
  }

  /** For a robot that is away, and a robot interface that has not begun. */
  static Clause fresh(String name, Part part, Capability... needs) {
    return new Clause(name, List.of(needs), peers -> {
      try (Trial trial = new Trial(peers)) {
        part.run(trial);
      }
    });
  }

  /** For those that are connected. */
  static Clause connected(String name, Part part, Capability... needs) {
    return new Clause(name, List.of(needs), peers -> {
      try (Trial trial = Trial.connected(peers)) {
        part.run(trial);
      }
    });
  }
}
