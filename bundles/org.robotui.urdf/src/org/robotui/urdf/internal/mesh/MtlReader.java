package org.robotui.urdf.internal.mesh;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.robotui.urdf.Color;
import org.robotui.urdf.internal.Refusal;

/** Reads the materials of OBJ files: colours, opacity and the picture. */
final class MtlReader {
  /** What may stand before the name of a picture, for example {@code -s 1 1 1}. */
  private static final Pattern OPTIONS = Pattern.compile("^(?:-[a-z]+(?:\\s+(?:on|off|[-+.\\d]+))*\\s+)+");
  private static final Color GREY = new Color(0.8f, 0.8f, 0.8f, 1);

  private MtlReader() {}

  /** How a part looks. */
  record Look(Optional<Color> color, Optional<String> texture) {
    static final Look NONE = new Look(Optional.empty(), Optional.empty());
  }

  static Map<String, Look> read(byte[] bytes) throws Refusal {
    Map<String, Look> looks = new HashMap<>();
    WordReader words = new WordReader(bytes);
    Optional<String> name = Optional.empty();
    Color color = GREY;
    Optional<String> texture = Optional.empty();
    for (Optional<String> word = words.next(); word.isPresent(); word = words.next()) {
      switch (word.get()) {
        case "newmtl" -> {
          name = Optional.of(words.rest());
          color = GREY;
          texture = Optional.empty();
        }
        case "Kd" -> color = new Color(words.number(), words.number(), words.number(), color.alpha());
        case "d" -> color = alpha(color, words.number());
        case "Tr" -> color = alpha(color, 1 - words.number());
        case "map_Kd" -> texture =
            Optional.of(OPTIONS.matcher(words.rest()).replaceFirst("")).filter(file -> !file.isEmpty());
        default -> {}
      }
      words.skipLine();
      Look look = new Look(Optional.of(color), texture);
      name.ifPresent(n -> looks.put(n, look));
    }
    return looks;
  }

  private static Color alpha(Color color, float alpha) {
    return new Color(color.red(), color.green(), color.blue(), alpha);
  }
}
