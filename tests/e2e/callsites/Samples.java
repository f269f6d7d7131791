import elsewhere.Base;
import java.io.Serializable;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.BiFunction;
import java.util.function.DoubleSupplier;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.function.IntUnaryOperator;
import java.util.function.LongFunction;
import java.util.function.Supplier;
import java.util.function.ToLongFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Call sites of all kinds; what they give is printed, and must be the same however they are linked. */
public class Samples extends Base {
  interface Named {
    String name();

    default Supplier<String> greeting() {
      return () -> secret() + name();
    }

    private String secret() {
      return "hello ";
    }
  }

  interface Shape {}

  record Circle(double radius) implements Shape {}

  record Box(int width, long height, String name, boolean open, float deep, char mark, byte small, short less,
      Circle lid) implements Shape {}

  record Empty() implements Shape {}

  interface Copying<T> extends Function<T, T> {
    @Override
    T apply(T value);
  }

  private final String own = "own";

  public static void main(String[] arguments) throws Exception {
    new Samples().lambdas(7, 8L, 9.5);
    new Samples().references();
    conversions();
    records();
    Stream.of(new Circle(1), box(2), new Empty(), "word", "other", 5, 50, 'c', List.of()).map(Samples::told)
        .forEach(System.out::println);
  }

  private void lambdas(int i, long l, double d) throws Exception {
    Supplier<String> captured = () -> own + i + l + d;
    System.out.println(captured.get());
    Function<Integer, Function<Integer, Integer>> nested = a -> b -> a * b + i;
    System.out.println(nested.apply(3).apply(4));
    Named named = () -> "you";
    System.out.println(named.greeting().get());
    Callable<String> failing = () -> {
      throw new IllegalStateException(own);
    };
    try {
      failing.call();
    } catch (IllegalStateException e) {
      System.out.println("thrown: " + e.getMessage());
    }
    Runnable dropped = () -> hidden(l);
    dropped.run();
    Runnable kept = (Runnable & Serializable) () -> System.out.println("can be serialized");
    kept.run();
    System.out.println(one() == one());
    Copying<String> copying = word -> word + word;
    Function<String, String> bridged = copying;
    System.out.println(bridged.apply("ab"));
  }

  private static Supplier<String> one() {
    return () -> "one";
  }

  private long hidden(long value) {
    System.out.println("hidden " + value);
    return value;
  }

  @Override
  public String open(String word) {
    Function<String, String> above = super::open;
    return "below " + above.apply(word);
  }

  private void references() {
    Function<String, String> inherited = this::inherited;
    Function<String, String> open = this::open;
    System.out.println(inherited.apply("a") + open.apply("b"));
    Function<String, Integer> length = String::length;
    Function<String, StringBuilder> made = StringBuilder::new;
    IntFunction<int[]> array = int[]::new;
    Function<int[], int[]> copied = int[]::clone;
    BiFunction<Double, Double, Boolean> greater = Samples::greater;
    System.out
        .println(length.apply("four") + " " + made.apply("x").append('y') + " " + copied.apply(array.apply(3)).length
            + " " + greater.apply(2.0, 1.0));
    Function<String, List<String>> many = List::of;
    System.out.println(Stream.of("b", "a").map(many).toList());
    System.out.println(Stream.of("b", "a", "cc").sorted(Comparator.comparing(String::length).reversed()
        .thenComparing(Comparator.naturalOrder())).collect(Collectors.joining(",")));
    Supplier<Function<String, String>> deep = () -> this::inherited;
    System.out.println(deep.get().apply("deep"));
  }

  private static boolean greater(double a, double b) {
    return a > b;
  }

  private static void conversions() {
    ToLongFunction<Integer> widened = Integer::intValue;
    LongFunction<Object> boxed = value -> value;
    DoubleSupplier wider = "four"::length;
    IntUnaryOperator folded = Math::abs;
    Function<Integer, Long> through = Samples::twice;
    Function<Character, Integer> code = Samples::code;
    Supplier<? super Integer> some = () -> 3;
    System.out.println(widened.applyAsLong(5) + " " + boxed.apply(6) + " " + wider.getAsDouble() + " "
        + folded.applyAsInt(-7) + " " + through.apply(8) + " " + code.apply('A') + " " + some.get());
  }

  private static long twice(long value) {
    return 2 * value;
  }

  private static int code(int letter) {
    return letter;
  }

  private static Box box(int width) {
    return new Box(width, 1L << 40, width > 2 ? null : "box", true, 0.5f, 'm', (byte) -1, (short) 7, new Circle(-0.0));
  }

  private static void records() {
    System.out.println(box(2).equals(box(2)) + " " + box(2).equals(box(3)) + " " + box(3).equals(box(3)) + " "
        + box(2).equals(null) + " " + new Circle(0.0).equals(new Circle(-0.0)) + " "
        + new Circle(Double.NaN).equals(new Circle(Double.NaN)) + " " + new Empty().equals(new Empty()));
    System.out.println(box(2).hashCode() + " " + box(3).hashCode() + " " + new Empty().hashCode() + " " + box(2));
  }

  private static String told(Object value) {
    return switch (value) {
      case Circle circle -> "circle " + circle.radius();
      case Box(int width, long height, String name, var open, var deep, var mark, var small, var less, Circle lid) when width > 1 -> "wide "
          + height + name + lid;
      case Shape shape -> "shape " + shape;
      case String word when word.length() > 4 -> "long " + word;
      case String word -> "short " + word;
      case Integer number when number > 10 -> "large " + number;
      case Number number -> "number " + number;
      case Character letter -> "letter " + letter;
      default -> "other " + value;
    };
  }
}
