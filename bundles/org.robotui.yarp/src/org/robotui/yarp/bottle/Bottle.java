package org.robotui.yarp.bottle;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;

/**
 * A list of values: what YARP's ports send. Where all values have one type, it is usually sent once for all of them.
 *
 * @param values in order
 * @param element the number of the type of all values; 0 where each says its own
 */
public record Bottle(List<YarpValue> values, int element) implements YarpValue {

  /** With a list of its own; refuses values of another type with an {@link IllegalArgumentException}. */
  public Bottle {
    boolean reals = values instanceof RealList list && list.tag() == element;
    values = reals ? values : List.copyOf(values);
    if (element != 0 && !reals) {
      for (YarpValue value : values) {
        if (BottleTag.of(value) != element) {
          throw new IllegalArgumentException(value + " is not of the type " + element + " of its list");
        }
      }
    }
  }

  /**
   * A list as YARP's own programs make it: with one type where all values have it and are no lists.
   *
   * @param values in order
   * @return the list
   */
  public static Bottle of(List<? extends YarpValue> values) {
    List<YarpValue> all = List.copyOf(values);
    int first = all.isEmpty() ? 0 : BottleTag.of(all.getFirst());
    boolean same = first < BottleTag.LIST && all.stream().allMatch(value -> BottleTag.of(value) == first);
    return new Bottle(all, same ? first : 0);
  }

  /**
   * A list of what Java has.
   *
   * @param values numbers (whole ones of 32 bits, others of 64), flags, texts, lists of such, and values of YARP
   * @return the list
   */
  public static Bottle of(Object... values) {
    List<YarpValue> all = new ArrayList<>();
    for (Object value : values) {
      all.add(value(value));
    }
    return of(all);
  }

  private static YarpValue value(Object value) {
    return switch (value) {
      case YarpValue own -> own;
      case Integer whole -> new Whole(whole, Integer.SIZE);
      case Long whole -> new Whole(whole, Long.SIZE);
      case Number number -> new Real(number.doubleValue(), Double.SIZE);
      case Boolean flag -> new Whole(flag ? 1 : 0, Integer.SIZE);
      case List<?> list -> of(list.toArray());
      default -> new Text(String.valueOf(value));
    };
  }

  /**
   * Words that are sent as vocabularies.
   *
   * @param words up to four characters each
   * @return their values, to be put into lists
   */
  public static List<YarpValue> vocabs(String... words) {
    List<YarpValue> all = new ArrayList<>();
    for (String word : words) {
      all.add(Vocab.of(word));
    }
    return all;
  }

  /**
   * A list of numbers.
   *
   * @param numbers in order
   * @return the list
   */
  public static Bottle reals(double... numbers) {
    return of(DoubleStream.of(numbers).mapToObj(number -> new Real(number, Double.SIZE)).toList());
  }

  /**
   * How many values it has.
   *
   * @return 0 where it is empty
   */
  public int size() {
    return values.size();
  }

  /**
   * One of its values.
   *
   * @param index from 0
   * @return an empty text where there is none, as YARP's programs take it
   */
  public YarpValue get(int index) {
    return index >= 0 && index < values.size() ? values.get(index) : new Text("");
  }

  /**
   * All values as numbers.
   *
   * @return not a number for what is none
   */
  public double[] numbers() {
    return values instanceof RealList reals ? reals.numbers()
        : values.stream().mapToDouble(YarpValue::number).toArray();
  }

  /** As YARP writes it. */
  @Override
  public String toString() {
    return BottleText.format(this);
  }
}
