package org.robotui.api.host;

import java.util.List;
import java.util.Optional;
import org.robotui.api.link.LinkState;

/**
 * What is known so far of a robot for which a UI is put together.
 *
 * @param stage how far it is
 * @param sentence for users: what is so, and where it failed, what would help
 * @param link how the robot is reached
 * @param ports what it offers, or, where it is not reached, what its type always offers
 * @param views every type of view, those that fit first
 * @param ruics every type of RUIC, the best first
 */
public record CompositionState(Stage stage, String sentence, LinkState link, List<PortStatus> ports, List<ViewFit> views, List<RuicFit> ruics) {
  /** How far it is. */
  public enum Stage {
    /** It is not reached yet. */
    CONNECTING,
    /** It is reached, and more ports may still come. */
    LOOKING,
    /** It is reached, and nothing new was found for a while. */
    FOUND,
    /** It is not reached, but its type says what there will be. */
    KNOWN,
    /** It is not reached within the time that a robot takes. */
    UNREACHED,
    /** The interface cannot be started like this. */
    FAILED
  }

  /**
   * Copies the lists.
   *
   * @param stage how far it is
   * @param sentence for users
   * @param link how the robot is reached
   * @param ports what it offers
   * @param views types of views
   * @param ruics types of RUICs
   */
  public CompositionState {
    ports = List.copyOf(ports);
    views = List.copyOf(views);
    ruics = List.copyOf(ruics);
  }

  /**
   * Whether views can be chosen.
   *
   * @return true where it is known what the robot offers
   */
  public boolean usable() {
    return stage == Stage.LOOKING || stage == Stage.FOUND || stage == Stage.KNOWN;
  }

  /**
   * A type of view.
   *
   * @param type its id
   * @return how well it fits, or none where it is not installed
   */
  public Optional<ViewFit> view(String type) {
    return views.stream().filter(v -> v.type().equals(type)).findFirst();
  }

  /**
   * A type of RUIC.
   *
   * @param type its id
   * @return how well it fits, or none where it is not installed
   */
  public Optional<RuicFit> ruic(String type) {
    return ruics.stream().filter(r -> r.type().equals(type)).findFirst();
  }
}
