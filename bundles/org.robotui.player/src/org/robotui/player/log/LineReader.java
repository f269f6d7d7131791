package org.robotui.player.log;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.robotui.player.layout.PlayerRecord;
import org.robotui.player.layout.StructLayout;
import org.robotui.player.wire.PlayerException;

/** Reads the rest of a line into a record. What a line does not tell is zero. */
final class LineReader {

  private final String[] words;
  private int at;
  private int length;
  private final Map<String, Object> values = new HashMap<>();

  private LineReader(String[] words, int at) {
    this.words = words;
    this.at = at;
  }

  static PlayerRecord read(LineLayout layout, StructLayout struct, String[] words, int from) throws PlayerException {
    LineReader reader = new LineReader(words, from);
    for (LinePart part : layout.parts()) {
      reader.part(part);
    }
    if (reader.at < words.length) {
      throw new PlayerException((words.length - reader.at) + " words are left over from '" + words[reader.at] + "'");
    }
    return PlayerRecord.of(struct, reader.values);
  }

  private void part(LinePart part) throws PlayerException {
    switch (part) {
      case LinePart.Scalar scalar -> put(values, scalar.path(), number());
      case LinePart.Length count -> length = length();
      case LinePart.Each each -> each(each.parts());
      case LinePart.Hex hex -> put(values, hex.path(), hex());
      case LinePart.Element element -> throw new IllegalStateException(element + " stands outside of brackets");
    }
  }

  private int length() throws PlayerException {
    double count = number();
    if (count < 0 || count > Integer.MAX_VALUE || count != Math.rint(count)) {
      throw new PlayerException("'" + words[at - 1] + "' is no number of elements");
    }
    return (int) count;
  }

  private void each(List<LinePart.Element> parts) throws PlayerException {
    if ((long) length * parts.size() > words.length - at) {
      throw new PlayerException(length + " elements announced, but " + (words.length - at) + " words follow");
    }
    Map<String, List<Object>> arrays = new HashMap<>();
    for (int i = 0; i < length; i++) {
      for (LinePart.Element part : parts) {
        element(arrays.computeIfAbsent(part.array(), none -> new ArrayList<>()), i, part.path(), number());
      }
    }
    arrays.forEach((array, elements) -> put(values, array, elements));
  }

  @SuppressWarnings("unchecked")
  private static void element(List<Object> array, int index, String path, double value) {
    if (path.isEmpty()) {
      array.add(value);
      return;
    }
    if (array.size() <= index) {
      array.add(new HashMap<String, Object>());
    }
    put((Map<String, Object>) array.get(index), path, value);
  }

  @SuppressWarnings("unchecked")
  private static void put(Map<String, Object> map, String path, Object value) {
    int dot = path.indexOf('.');
    if (dot < 0) {
      map.put(path, value);
    } else {
      Object inner = map.computeIfAbsent(path.substring(0, dot), none -> new HashMap<String, Object>());
      put((Map<String, Object>) inner, path.substring(dot + 1), value);
    }
  }

  private double number() throws PlayerException {
    String word = word();
    try {
      return NumberFormat.read(word);
    } catch (NumberFormatException e) {
      throw new PlayerException("'" + word + "' is no number");
    }
  }

  /** Pictures may have been left out. */
  private byte[] hex() throws PlayerException {
    String digits = at < words.length ? word() : "";
    try {
      return HexFormat.of().parseHex(digits);
    } catch (IllegalArgumentException e) {
      throw new PlayerException("the bytes are not in hexadecimal digits");
    }
  }

  private String word() throws PlayerException {
    if (at >= words.length) {
      throw new PlayerException("the line ends too early");
    }
    return words[at++];
  }
}
