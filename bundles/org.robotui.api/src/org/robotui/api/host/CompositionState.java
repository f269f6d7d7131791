package org.robotui.api.host;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.SourceId;

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
public record CompositionState(Stage stage, String sentence, LinkState link, List<PortStatus> ports,
    List<ViewFit> views, List<RuicFit> ruics) {
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

  /**
   * What is proposed to be shown with a type of RUIC: those of its views that fit. A view that has to be told its ports
   * is among them.
   *
   * @param ruic id of the type
   * @return types of views, in the order of its layout
   */
  public List<String> proposedViews(String ruic) {
    return ruic(ruic).stream().flatMap(r -> r.views().stream()).filter(v -> view(v).filter(ViewFit::fits).isPresent())
        .toList();
  }

  /**
   * What is proposed where several ports fit: the one with the shortest name, which is the plain one where others are
   * derived, else the first.
   *
   * @param shown types of views
   * @return the port of the robot by port of a view
   */
  public Map<SourceId, SourceId> proposedConnections(List<String> shown) {
    Map<SourceId, SourceId> all = new LinkedHashMap<>();
    shown.stream().flatMap(v -> view(v).stream()).flatMap(v -> v.choices().stream())
        .forEach(m -> m.candidates().stream().min(Comparator.comparingInt(c -> c.port().length()))
            .ifPresent(c -> all.put(m.port(), c)));
    return all;
  }
}
