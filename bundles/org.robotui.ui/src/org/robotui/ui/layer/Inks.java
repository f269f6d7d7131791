package org.robotui.ui.layer;

import java.util.Optional;
import java.util.regex.Pattern;
import org.eclipse.swt.graphics.RGB;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.ui.scene.Ink;

/** The setting of layers that holds their colour. */
public final class Inks {
  /** The name of the setting. */
  public static final String COLOR = "color";

  private static final Pattern WRITTEN = Pattern.compile("#[0-9a-fA-F]{6}");
  private static final ValueType TYPE =
      new ValueType.Text(TextRule.matching("a colour, such as \"#f76b15\"", WRITTEN.pattern()).orEmpty("\"\""));
  private static final int HEX = 16;
  private static final int BYTE = 0xff;

  private Inks() {}

  /**
   * The setting for the colour of a layer, which has its usual one where nothing is written.
   *
   * @param usual what that colour is, for example {@code that of lasers}
   * @return the setting {@value #COLOR}
   */
  public static Setting setting(String usual) {
    return Setting.of(COLOR, TYPE, "",
        "Its colour, written as #f76b15; without, " + usual + ", or that of its robot where there are several.");
  }

  /**
   * The colour that is chosen in settings.
   *
   * @param settings of a layer, checked
   * @return the colour, or none where none is written or the layer has no such setting
   */
  public static Optional<Ink> chosen(Settings settings) {
    return Optional.ofNullable(settings.values().get(COLOR)).map(Object::toString)
        .filter(text -> WRITTEN.matcher(text).matches()).map(Inks::parse);
  }

  private static Ink parse(String text) {
    int rgb = Integer.parseInt(text.substring(1), HEX);
    return new Ink.Chosen(new RGB(rgb >> 16 & BYTE, rgb >> 8 & BYTE, rgb & BYTE));
  }
}
