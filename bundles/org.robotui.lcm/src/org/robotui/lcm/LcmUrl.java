package org.robotui.lcm;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Where messages come from and go to, as all LCM programs are told: {@code udpm://239.255.76.67:7667?ttl=0},
 * {@code tcpq://127.0.0.1:7700}, {@code file:///path/of.lcmlog?speed=2}, {@code memq://}.
 *
 * @param provider the part before {@code ://}
 * @param network the part after it: an address or a file
 * @param options what follows a question mark
 */
public record LcmUrl(String provider, String network, Map<String, String> options) {

  /** The variable from which all LCM programs take their URL. */
  public static final String VARIABLE = "LCM_DEFAULT_URL";

  /** What they use without it: multicast that does not leave this machine. */
  public static final String DEFAULT = "udpm://239.255.76.67:7667?ttl=0";

  private static final Pattern FORM = Pattern.compile("([a-z]+)://([^?]*)(?:\\?(.*))?");

  /** Copies the options. */
  public LcmUrl {
    options = Map.copyOf(options);
  }

  /**
   * Reads a URL.
   *
   * @param text the URL
   * @return its parts, which the provider reads when it is opened
   * @throws IllegalArgumentException if it is no such URL; the message says what to write
   */
  public static LcmUrl of(String text) {
    Matcher form = FORM.matcher(text.strip());
    if (!form.matches()) {
      throw new IllegalArgumentException("'" + text + "' is no LCM URL; write for example " + DEFAULT);
    }
    Map<String, String> options = new LinkedHashMap<>();
    String rest = Optional.ofNullable(form.group(3)).orElse("");
    for (String option : rest.isEmpty() ? new String[0] : rest.split("&")) {
      int equals = option.indexOf('=');
      if (equals < 1) {
        throw new IllegalArgumentException("'" + option + "' in '" + text + "' is no option; write NAME=VALUE");
      }
      options.put(option.substring(0, equals), option.substring(equals + 1));
    }
    return new LcmUrl(form.group(1), form.group(2), options);
  }

  /**
   * Takes the URL from where all LCM programs take it.
   *
   * @param variables the environment variables
   * @return that of {@link #VARIABLE}, else {@link #DEFAULT}
   * @throws IllegalArgumentException if the variable holds no such URL; the message names it
   */
  public static LcmUrl of(Map<String, String> variables) {
    String text = variables.getOrDefault(VARIABLE, "");
    try {
      return of(text.isBlank() ? DEFAULT : text);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(VARIABLE + ": " + e.getMessage(), e);
    }
  }

  /** As it is written. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder(provider).append("://").append(network);
    char separator = '?';
    for (Map.Entry<String, String> option : new TreeMap<>(options).entrySet()) {
      text.append(separator).append(option.getKey()).append('=').append(option.getValue());
      separator = '&';
    }
    return text.toString();
  }
}
