package org.robotui.rfic.lcm.internal.language;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.config.Placed;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.TypeLibrary;

/**
 * Which members of a channel's messages are which fields, as a configuration says it.
 *
 * @param place where it is written
 * @param channel the channel
 * @param form what the fields are of
 * @param written what is written for fields, by their names
 */
public record Mapping(Placed place, String channel, Form form, Map<String, Entry> written) {
  /**
   * What is written for one field.
   *
   * @param source where its value comes from
   * @param place where that is written
   */
  public record Entry(Source source, Placed place) {}

  /** Copies the map. */
  public Mapping {
    written = Map.copyOf(written);
  }

  /**
   * Reads the fields of a mapping.
   *
   * @param place where it is written
   * @param channel the channel
   * @param form what the fields are of
   * @param entries what is written, without the words that are no fields
   * @return the mapping
   * @throws FaultException where a field is unknown, or what is written for it is none
   */
  public static Mapping parse(Placed place, String channel, Form form, Map<String, Placed> entries)
      throws FaultException {
    Map<String, Entry> written = new LinkedHashMap<>();
    for (Map.Entry<String, Placed> entry : entries.entrySet()) {
      Placed at = entry.getValue();
      Field field = form.field(entry.getKey()).orElseThrow(() -> new FaultException(
          at.fault("'" + form.word() + "' has no field '" + entry.getKey() + "'; it has " + form.names())));
      try {
        written.put(field.name(), new Entry(Source.parse(at.value(), field), at));
      } catch (IllegalArgumentException e) {
        throw new FaultException(at.fault("'" + field.name() + "' of " + channel + ": " + e.getMessage()));
      }
    }
    return new Mapping(place, channel, form, written);
  }

  /**
   * Finds the members in a type.
   *
   * @param type of the messages
   * @param types all types
   * @return where each field comes from: what is written, and what can be assumed
   * @throws FaultException where a member is not there or holds something else, or a field is missing
   */
  public Map<String, Source> bind(LcmType type, TypeLibrary types) throws FaultException {
    Map<String, Source> bound = new HashMap<>();
    Set<String> said = new HashSet<>();
    for (Map.Entry<String, Entry> entry : written.entrySet()) {
      Field field = form.field(entry.getKey()).orElseThrow();
      said.add(field.group());
      bound.put(field.name(), checked(field, entry.getValue(), type, types));
    }
    form.fields().stream().filter(f -> !said.contains(f.group()))
        .forEach(f -> assumed(f, type, types).ifPresent(source -> bound.put(f.name(), source)));
    for (Form.Need need : form.needs()) {
      if (need.ways().stream().noneMatch(way -> bound.keySet().containsAll(way))) {
        throw new FaultException(place.fault(channel + " as " + form.word() + " needs " + need + "; write for example "
            + need.ways().getFirst().getFirst() + ": MEMBER, where MEMBER is one of " + members(type)));
      }
    }
    return bound;
  }

  private static List<String> members(LcmType type) {
    return type.definition().members().stream().map(m -> m.toString()).toList();
  }

  private Source checked(Field field, Entry entry, LcmType type, TypeLibrary types) throws FaultException {
    try {
      check(field, entry.source(), type, types);
      return entry.source();
    } catch (IllegalArgumentException e) {
      throw new FaultException(entry.place().fault("'" + field.name() + "' of " + channel + ": " + e.getMessage()));
    }
  }

  private static Optional<Source> assumed(Field field, LcmType type, TypeLibrary types) {
    for (String text : field.assumed()) {
      try {
        Source source = Source.parse(field.kind() == Field.Kind.TEXT ? "$" + text : text, field);
        check(field, source, type, types);
        return Optional.of(source);
      } catch (IllegalArgumentException e) {
        continue; // the type has no such member: the next one
      }
    }
    return Optional.empty();
  }

  private static void check(Field field, Source source, LcmType type, TypeLibrary types) {
    List<Source.Member> members = new ArrayList<>();
    switch (source) {
      case Source.Member m -> members.add(m);
      case Source.Sum s -> members.addAll(s.parts());
      case Source.Constant c -> {}
      case Source.Words w -> {}
    }
    members.forEach(m -> Target.of(m.path(), type, types).check(field, m.path().toString()));
  }
}
