package org.robotui.uic.connections.internal.model;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.ui.Health;
import org.robotui.ui.LinkLook;
import org.robotui.ui.MatchLook;
import org.robotui.ui.PortLook;

/**
 * One line of the list: a RUIC, a component of it, or a port or a bridge of that. Its words are made when they are
 * asked for.
 */
public sealed interface ConnectionLine permits ConnectionLine.Robot, ConnectionLine.Part, ConnectionLine.RobotPort,
    ConnectionLine.ViewPort, BridgeLine {
  /** The word of a view that has not failed. */
  String VIEW = "view";

  /** What identifies it, so that it stays selected and folded while others come and go. */
  String key();

  /** The RUIC that it belongs to. */
  String ruic();

  /** The dot. */
  Health health();

  /** What it is. */
  String name();

  /** The word of its state. */
  String word();

  /** Why it is so, or what it is connected with, or its newest value. */
  String text();

  /** How deep it lies: 0 a RUIC, 1 a component, 2 a port. */
  default int level() {
    return 2;
  }

  /** How long it has been so, or empty. */
  default String since() {
    return "";
  }

  /** How old its newest value is, or empty. */
  default String age() {
    return "";
  }

  /** What was lost, or empty. */
  default String dropped() {
    return "";
  }

  /** Everything about it, for tooltip, clipboard and search. */
  default String details() {
    return name() + "\n" + word() + "\n" + text();
  }

  /** Whether something is wrong here, or the user must decide. */
  default boolean isProblem() {
    return health() == Health.BAD || health() == Health.WARNING || health() == Health.STALE;
  }

  /** The decision that the user must make, if any. */
  default Optional<Match> decision() {
    return Optional.empty();
  }

  /**
   * A RUIC.
   *
   * @param snapshot how it is doing
   * @param problems how many lines below it are problems
   */
  record Robot(RuicSnapshot snapshot, int problems) implements ConnectionLine {
    @Override
    public String key() {
      return ruic();
    }

    @Override
    public String ruic() {
      return snapshot.name();
    }

    @Override
    public int level() {
      return 0;
    }

    @Override
    public Health health() {
      return snapshot.state() == RuicState.FAILED ? Health.BAD : LinkLook.health(snapshot.link());
    }

    @Override
    public String name() {
      return snapshot.name();
    }

    @Override
    public String word() {
      return snapshot.state() == RuicState.FAILED ? "failed" : snapshot.link().word();
    }

    @Override
    public String text() {
      if (snapshot.state() == RuicState.FAILED) {
        return snapshot.reason();
      }
      return problems == 0 ? "" : problems == 1 ? "1 problem" : problems + " problems";
    }

    @Override
    public boolean isProblem() {
      return snapshot.state() == RuicState.FAILED;
    }
  }

  /**
   * A robot interface with its link, or a view.
   *
   * @param ruic the RUIC
   * @param component how it is doing
   * @param held how long it has been so
   * @param ports the lines of its ports
   */
  record Part(String ruic, ComponentStatus component, Since held, List<ConnectionLine> ports)
      implements ConnectionLine {
    /** Copies the list. */
    public Part {
      ports = List.copyOf(ports);
    }

    private boolean isView() {
      return component.kind() == ComponentStatus.Kind.UIC && component.state() != RuicState.FAILED;
    }

    @Override
    public String key() {
      return ruic + "\n" + component.id();
    }

    @Override
    public int level() {
      return 1;
    }

    /** A view is as well as the worst of its ports. */
    @Override
    public Health health() {
      if (!isView()) {
        return LinkLook.health(component);
      }
      return Stream.of(Health.BAD, Health.WARNING, Health.WAITING, Health.OK)
          .filter(health -> ports.stream().anyMatch(port -> port.health() == health)).findFirst().orElse(Health.NONE);
    }

    @Override
    public String name() {
      return LinkLook.name(component);
    }

    @Override
    public String word() {
      return isView() ? VIEW : LinkLook.word(component);
    }

    @Override
    public String text() {
      if (!isView()) {
        return LinkLook.text(component);
      }
      long connected = ports.stream().filter(port -> port.health() == Health.OK).count();
      return ports.isEmpty() ? "takes nothing from the robot" : connected + " of " + ports.size() + " ports connected";
    }

    @Override
    public String since() {
      return isView() ? "" : held.words();
    }

    /** What is wrong with a view is said by its ports. */
    @Override
    public boolean isProblem() {
      return !isView() && health() != Health.OK;
    }
  }

  /**
   * A port of a robot interface.
   *
   * @param ruic the RUIC
   * @param port how it is doing
   */
  record RobotPort(String ruic, PortStatus port) implements ConnectionLine {
    @Override
    public String key() {
      return ruic + "\n" + port.kind() + " " + port.port();
    }

    @Override
    public Health health() {
      return PortLook.health(port);
    }

    @Override
    public String name() {
      return port.port().port();
    }

    @Override
    public String word() {
      return PortLook.word(port);
    }

    @Override
    public String text() {
      return PortLook.text(port);
    }

    @Override
    public String age() {
      return PortLook.age(port);
    }

    @Override
    public String dropped() {
      return PortLook.dropped(port);
    }

    @Override
    public String details() {
      return PortLook.details(port);
    }

    /** What only waits is none: many robots say things only when they happen. */
    @Override
    public boolean isProblem() {
      return ConnectionLine.super.isProblem() || port.dropped() > 0;
    }
  }

  /**
   * A port of a view.
   *
   * @param ruic the RUIC
   * @param match what matching says of it
   */
  record ViewPort(String ruic, Match match) implements ConnectionLine {
    @Override
    public String key() {
      return ruic + "\n" + match.kind() + " " + match.port();
    }

    @Override
    public Health health() {
      return MatchLook.health(match);
    }

    @Override
    public String name() {
      return match.port().port() + " \u00b7 " + match.typeName();
    }

    @Override
    public String word() {
      return MatchLook.word(match);
    }

    @Override
    public String text() {
      return MatchLook.text(match);
    }

    @Override
    public String details() {
      return MatchLook.details(match);
    }

    @Override
    public boolean isProblem() {
      return MatchLook.missing(match);
    }

    @Override
    public Optional<Match> decision() {
      return match.state() == MatchState.AMBIGUOUS && !match.candidates().isEmpty() ? Optional.of(match)
          : Optional.empty();
    }
  }
}
