package org.robotui.entity.tf.internal.display;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows where frames are. */
@Component(service = DisplayType.class)
public final class TfType implements DisplayType {
  static final String SIZE = "size";
  static final String NAMES = "names";
  static final String LINKS = "links";
  static final String FRAMES = "frames";
  static final String HIDDEN = "hidden_frames";
  static final String LINK_COLOR = "link_color";
  static final String NAME_COLOR = "name_color";

  private static final ValueType WORDS = new ValueType.ListOf(new ValueType.Text());
  static final Schema SCHEMA = Schema.of(
      Setting.of(SIZE, new ValueType.Num(0.001, 100, "m"), 0.3, "How long the axes are."),
      Setting.of(NAMES, new ValueType.Flag(), true, "Whether names stand beside the frames."),
      Setting.of(LINKS, new ValueType.Flag(), true, "Whether lines lead to their parent frames."),
      Setting.of(FRAMES, WORDS, List.of(),
          "The frames that are shown, by name or as robot/name; a * at the end stands for any rest. Empty for all."),
      Setting.of(HIDDEN, WORDS, List.of(), "Frames that are not shown, written in the same way."),
      ColorSetting.of(LINK_COLOR, "#d9a53a", "Colour of the lines."),
      ColorSetting.of(NAME_COLOR, "#8a919c", "Colour of the names."));

  @Override
  public String id() {
    return "tf";
  }

  @Override
  public String label() {
    return "Frames";
  }

  @Override
  public String help() {
    return "Shows where coordinate frames are: axes (x red, y green, z blue), names, and lines to the frames that carry them.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of();
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new TfDisplay();
  }
}
