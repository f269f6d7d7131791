package org.robotui.uic.tftree.internal.model;

import java.util.Optional;
import org.robotui.api.frame.FrameLink;
import org.robotui.data.FrameId;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;

/**
 * A frame in the tree.
 *
 * @param id which
 * @param title its name, with that of the robot where there are several
 * @param depth how many frames carry it
 * @param link the transform that carries it, none for a root
 * @param below how many frames lie below it, at any depth
 * @param open whether they are shown
 * @param age seconds since its transform came; 0 where it is fixed
 * @param problem what is wrong with it, empty where nothing is
 * @param health the dot
 */
public record FrameRow(FrameId id, String title, int depth, Optional<FrameLink> link, int below, boolean open,
    double age, String problem, Health health) {
  static FrameRow of(FrameId id, String title, int depth, Optional<FrameLink> link, int below, boolean open, double age,
      double staleAfter) {
    boolean stale = link.filter(l -> !l.fixed()).isPresent() && age > staleAfter;
    String rivals = link.map(FrameRow::rivals).orElse("");
    String problem = !rivals.isEmpty() ? rivals : stale ? "nothing for " + Figures.age(age) : "";
    Health health = !rivals.isEmpty() ? Health.BAD
        : stale ? Health.STALE : link.filter(l -> !l.fixed()).isPresent() ? Health.OK : Health.NONE;
    return new FrameRow(id, title, depth, link, below, open, age, problem, health);
  }

  private static String rivals(FrameLink link) {
    if (link.rivals().isEmpty()) {
      return "";
    }
    FrameLink.Rival rival = link.rivals().getFirst();
    String also = rival.authority() + " also publishes it";
    return rival.parent().equals(link.parent()) ? also : also + ", in " + rival.parent().name();
  }

  /** Whether something is wrong here. */
  public boolean isProblem() {
    return !problem.isEmpty();
  }

  /** How it moves: static, its rate, or a root. */
  public String rate() {
    return link.map(l -> l.fixed() ? "static" : Figures.rate(l.rateHz())).orElse("root");
  }

  /** The age of its transform, where that means anything. */
  public String ageWords() {
    return link.filter(l -> !l.fixed()).map(l -> Figures.age(age)).orElse("");
  }

  /** A few words for the drawing. */
  public String note() {
    String hidden = open || below == 0 ? "" : "  +" + below;
    if (isProblem()) {
      return problem + hidden;
    }
    return (link.isEmpty() ? below == 1 ? "root of 1 frame" : "root of " + below + " frames"
        : ageWords().isEmpty() ? rate() : rate() + " \u00b7 " + ageWords()) + hidden;
  }
}
