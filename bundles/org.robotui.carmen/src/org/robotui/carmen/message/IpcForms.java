package org.robotui.carmen.message;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.carmen.format.IpcFormat;

/** The messages that are known by name. Immutable. */
public final class IpcForms {

  private final Map<String, IpcForm> forms;

  private IpcForms(Map<String, IpcForm> forms) {
    this.forms = Map.copyOf(forms);
  }

  /**
   * Those of CARMEN 0.8.
   *
   * @return read from a file beside this class
   */
  public static IpcForms carmen() {
    try (InputStream in = IpcForms.class.getResourceAsStream("carmen.forms");
        BufferedReader lines = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))) {
      Map<String, IpcForm> forms = new LinkedHashMap<>();
      lines.lines().filter(line -> !line.isBlank() && !line.startsWith("#")).forEach(line -> {
        String[] parts = line.split("\\|");
        String name = parts[0].strip();
        forms.put(name, IpcForm.of(name, parts[1].strip(), parts[2].strip()));
      });
      return new IpcForms(forms);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * A message of CARMEN.
   *
   * @param name which
   * @return empty where it is none of those
   */
  public Optional<IpcForm> named(String name) {
    return Optional.ofNullable(forms.get(name));
  }

  /**
   * A message of CARMEN that is known to be one.
   *
   * @param name which
   * @return its form
   * @throws IllegalArgumentException where it is none of those
   */
  public IpcForm get(String name) {
    return named(name).orElseThrow(() -> new IllegalArgumentException("CARMEN has no message " + name));
  }

  /**
   * All names.
   *
   * @return in the order of the alphabet
   */
  public List<String> names() {
    return forms.keySet().stream().sorted().toList();
  }

  /**
   * A message as a central knows it: with names where they fit what it consists of there, else with numbers.
   *
   * @param name which
   * @param format as it is there
   * @return its form
   */
  public IpcForm of(String name, IpcFormat format) {
    return named(name).filter(known -> known.format().equals(format))
        .orElseGet(() -> named(name).filter(known -> FieldName.fit(known.fields(), format))
            .map(known -> new IpcForm(name, format.toString(), format, known.fields()))
            .orElseGet(() -> IpcForm.numbered(name, format)));
  }
}
