package org.robotui.uic.tftree.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.api.show.Showing;

/** Shows the coordinate frames of the robots as a tree, and where one lies in another. */
@Component(service = UicType.class)
public final class TfTreeType implements UicType {
  static final String FORM = "form";
  static final String DRAWN = "drawn";
  static final String LIST = "list";
  static final String PROBLEMS = "only_problems";
  static final String STALE_AFTER = "stale_after";
  static final String REFERENCE = "reference";

  private static final double RATE_HZ = 10;

  private static final Schema SCHEMA = Schema.of(
      Setting.of(FORM, new ValueType.Choice(List.of(DRAWN, LIST)), DRAWN, "Whether the tree is drawn or listed."),
      Setting.of(PROBLEMS, new ValueType.Flag(), false,
          "Whether only frames with a problem are shown, and those above them."),
      Setting.of(STALE_AFTER, new ValueType.Num(0.1, 3600, "s"), 3.0,
          "After how long without a transform a moving frame is stale."),
      Setting.of(REFERENCE, new ValueType.Text(TextRule.FRAME.orEmpty("\"\"")), "",
          "In which frame poses are shown, for example Keira:odom; parent for the parent of each, without it the root of its tree."));

  private static final Descriptor DESCRIPTOR = new Descriptor("tftree", "Frames",
      "The coordinate frames of the robots as a tree, how fresh each is, what is wrong, and where one lies in another.",
      SCHEMA, List.of());

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Surface surface() {
    return Surface.WINDOW;
  }

  @Override
  public double rateHz() {
    return RATE_HZ;
  }

  @Override
  public List<Showing> showings() {
    return List.of(Showing.frames("frame", "Show in Frames"));
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    return new TfTreeUic(context);
  }
}
