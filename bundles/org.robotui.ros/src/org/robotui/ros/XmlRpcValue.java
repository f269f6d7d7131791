package org.robotui.ros;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A value as XML-RPC knows it: what ROS parameters hold and what the master's and the nodes' APIs exchange. */
public sealed interface XmlRpcValue {

  /**
   * A string.
   *
   * @param value the text
   */
  record Text(String value) implements XmlRpcValue {}

  /**
   * A 32-bit integer.
   *
   * @param value the number
   */
  record Int(int value) implements XmlRpcValue {}

  /**
   * A truth value.
   *
   * @param value true or false
   */
  record Bool(boolean value) implements XmlRpcValue {}

  /**
   * A 64-bit float.
   *
   * @param value the number
   */
  record Real(double value) implements XmlRpcValue {}

  /**
   * A date, as it was written.
   *
   * @param iso8601 the text, such as {@code 20260131T12:00:00}
   */
  record DateTime(String iso8601) implements XmlRpcValue {}

  /**
   * Bytes.
   *
   * @param bytes the content; every access answers a copy
   */
  record Binary(byte[] bytes) implements XmlRpcValue {

    /** Copies the bytes. */
    public Binary {
      bytes = bytes.clone();
    }

    /** The content, as a copy. */
    @Override
    public byte[] bytes() {
      return bytes.clone();
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Binary that && Arrays.equals(bytes, that.bytes);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(bytes);
    }
  }

  /**
   * A list.
   *
   * @param items the elements, of any types
   */
  record Array(List<XmlRpcValue> items) implements XmlRpcValue {

    /** Copies the list. */
    public Array {
      items = List.copyOf(items);
    }
  }

  /**
   * A map, such as a namespace of parameters.
   *
   * @param members the members by name, in the order in which they came
   */
  record Struct(Map<String, XmlRpcValue> members) implements XmlRpcValue {

    /** Copies the map and keeps its order. */
    public Struct {
      members = Collections.unmodifiableMap(new LinkedHashMap<>(members));
    }
  }

  /**
   * A string.
   *
   * @param value the text
   * @return the value
   */
  static XmlRpcValue of(String value) {
    return new Text(value);
  }

  /**
   * An integer.
   *
   * @param value the number
   * @return the value
   */
  static XmlRpcValue of(int value) {
    return new Int(value);
  }

  /**
   * A float.
   *
   * @param value the number
   * @return the value
   */
  static XmlRpcValue of(double value) {
    return new Real(value);
  }

  /**
   * A truth value.
   *
   * @param value true or false
   * @return the value
   */
  static XmlRpcValue of(boolean value) {
    return new Bool(value);
  }

  /**
   * A list.
   *
   * @param items the elements
   * @return the value
   */
  static XmlRpcValue of(XmlRpcValue... items) {
    return new Array(List.of(items));
  }

  /**
   * A list of strings.
   *
   * @param items the texts
   * @return the value
   */
  static XmlRpcValue ofTexts(Iterable<String> items) {
    List<XmlRpcValue> values = new ArrayList<>();
    items.forEach(item -> values.add(of(item)));
    return new Array(values);
  }
}
