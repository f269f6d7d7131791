package org.robotui.gl.display;

import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.gl.shape.Rgba;

/**
 * Settings that hold a colour, written {@code "#rrggbb"} or {@code "#rrggbbaa"}. Their names are {@code color} or end
 * in {@code _color}.
 */
public final class ColorSetting {
  private static final Pattern COLOR = Pattern.compile("#([0-9a-fA-F]{6}|[0-9a-fA-F]{8})");
  private static final ValueType TYPE =
      new ValueType.Text(TextRule.matching("a colour, such as \"#f76b15\" or \"#f76b15c0\"", COLOR.pattern()));
  private static final int HEX = 16;
  private static final int BYTE = 0xff;

  private ColorSetting() {}

  /**
   * A setting for a colour.
   *
   * @param name {@code color}, or a name that ends in {@code _color}
   * @param fallback its colour when it is not written, as it would be written
   * @param help a sentence for users
   * @return the setting
   */
  public static Setting of(String name, String fallback, String help) {
    if (!isColor(name) || parse(fallback).isEmpty()) {
      throw new IllegalArgumentException(name + ": " + fallback);
    }
    return Setting.of(name, TYPE, fallback, help);
  }

  /**
   * The colour of a setting.
   *
   * @param settings checked
   * @param name of the setting
   * @return its colour; the fallback where what is written is no colour
   */
  public static Rgba read(Settings settings, String name) {
    return parse(settings.text(name)).or(() -> fallback(settings, name)).orElse(Rgba.WHITE);
  }

  /**
   * What is written in settings for colours, but is none.
   *
   * @param settings checked
   * @return a sentence, or nothing where all is well
   */
  public static Optional<String> complaint(Settings settings) {
    String wrong = settings.schema().settings().stream()
        .map(Setting::name)
        .filter(name -> isColor(name) && settings.has(name) && parse(settings.text(name)).isEmpty())
        .map(name -> name + " \"" + settings.text(name) + "\" is no colour; write it like \"#f76b15\"")
        .collect(Collectors.joining("; "));
    return Optional.of(wrong).filter(words -> !words.isEmpty());
  }

  /**
   * Reads a colour.
   *
   * @param text {@code #rrggbb} or {@code #rrggbbaa}
   * @return the colour, or none where it is written in another way
   */
  public static Optional<Rgba> parse(String text) {
    if (!COLOR.matcher(text).matches()) {
      return Optional.empty();
    }
    int rgb = Integer.parseInt(text.substring(1, 7), HEX);
    int alpha = text.length() > 7 ? Integer.parseInt(text.substring(7), HEX) : BYTE;
    return Optional.of(Rgba.of(rgb).withAlpha(alpha / (double) BYTE));
  }

  private static boolean isColor(String name) {
    return name.equals("color") || name.endsWith("_color");
  }

  private static Optional<Rgba> fallback(Settings settings, String name) {
    return settings.schema().find(name).flatMap(Setting::fallback).flatMap(text -> parse(text.toString()));
  }
}
