package org.robotui.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DefinitionParserTest {

  @Test
  void fieldsKeepTheirOrderAndTypesGetTheirFullNames() throws Exception {
    MessageDefinition d = DefinitionParser.parse("my_pkg/Thing", """
        # a comment
        Header header   # another
          float64[36]\tcovariance
        Part[] parts
        geometry_msgs/Point[2] ends
        string name""", Generation.ROS1);
    assertEquals(List.of("std_msgs/Header header", "float64[36] covariance", "my_pkg/Part[] parts",
        "geometry_msgs/Point[2] ends", "string name"),
        d.fields().stream().map(f -> f.type() + " " + f.name()).toList());
  }

  @Test
  void textConstantsKeepTheirHashSignsAndOthersLoseTheirComments() throws Exception {
    MessageDefinition d = DefinitionParser.parse("p/T", """
        string COLOUR= #ff0000 is red # not a comment\s\s
        int32 A = 5 # five
        float32 PI=3.14""", Generation.ROS1);
    assertEquals(List.of(
        new ConstantDefinition(Primitive.STRING, "COLOUR", "#ff0000 is red # not a comment"),
        new ConstantDefinition(Primitive.INT32, "A", "5"),
        new ConstantDefinition(Primitive.FLOAT32, "PI", "3.14")), d.constants());
  }

  @ParameterizedTest
  @ValueSource(strings = {"float64", "float64 x y", "float64[ x", "float64[-1] x", "a/b/c x", "int32 1x",
      "time T=5", "Foo A=1", "int32 x\nint32 x", "float64[9999999999] x"})
  void linesThatAreNoDefinitionAreRefusedWithTheirNumber(String text) {
    DefinitionException e =
        assertThrows(DefinitionException.class,
            () -> DefinitionParser.parse("p/T", "bool ok\n" + text, Generation.ROS1));
    assertTrue(e.getMessage().contains("p/T, line "), e.getMessage());
  }

  @Test
  void aFullTextIsTakenApartAndPutTogetherAgain() throws Exception {
    Map<String, String> texts = Map.of("p/A", "B[] bs\nstd_msgs/Header h", "p/B", "C c", "p/C", "int8 x",
        "std_msgs/Header", "uint32 seq");
    DefinitionSource source = name -> Optional.of(DefinitionParser.parse(name, texts.get(name), Generation.ROS1));
    MessageSchema made = MessageSchema.resolve(source.find("p/A").orElseThrow(), source);
    String separator = "\n" + "=".repeat(80) + "\nMSG: ";
    assertEquals("B[] bs\nstd_msgs/Header h" + separator + "p/B\nC c" + separator + "p/C\nint8 x" + separator
        + "std_msgs/Header\nuint32 seq", made.info().definition());
    MessageSchema read = MessageSchema.parse("p/A", made.info().definition());
    assertEquals(made.info(), read.info());
  }

  @Test
  void aTypeThatContainsItselfIsRefused() {
    String text = "B b\n===\nMSG: p/B\nC c\n===\nMSG: p/C\nB[] more";
    DefinitionException e = assertThrows(DefinitionException.class, () -> MessageSchema.parse("p/A", text));
    assertTrue(e.getMessage().contains("contains itself"), e.getMessage());
    assertThrows(DefinitionException.class, () -> MessageSchema.parse("p/A", "A again"));
  }

  @Test
  void aMissingTypeIsNamedWithTheFieldThatNeedsIt() {
    DefinitionException e =
        assertThrows(DefinitionException.class, () -> MessageSchema.parse("p/A", "other/B[] things"));
    assertEquals("definition of p/A: the type other/B of field p/A.things is not known", e.getMessage());
  }

  @Test
  void deepNestingIsRefusedWhateverTheOrderOfTheFields() {
    StringBuilder text = new StringBuilder("T1 a");
    for (int i = 1; i < 100; i++) {
      text.append("\n===\nMSG: p/T").append(i).append("\nT").append(i + 1).append(" a");
    }
    text.append("\n===\nMSG: p/T100\nbool x");
    assertThrows(DefinitionException.class, () -> MessageSchema.parse("p/A", text.toString()));
  }

  @Test
  void sizesThatOverflowAreSaturated() throws Exception {
    MessageSchema huge = MessageSchema.parse("p/A",
        "B[999999999] b\n===\nMSG: p/B\nC[999999999] c\n===\nMSG: p/C\nfloat64[999999999] d");
    assertEquals(Long.MAX_VALUE, huge.minSize());
  }

  @Test
  void aServiceHasTwoParts() throws Exception {
    ServiceDefinition s = ServiceDefinition.parse("p/S", "int8 a\n---\nint8 b\nint8 c", Generation.ROS1);
    assertEquals("p/SRequest", s.request().type());
    assertEquals(1, s.request().fields().size());
    assertEquals(2, s.response().fields().size());
    assertThrows(DefinitionException.class, () -> ServiceDefinition.parse("p/S", "int8 a", Generation.ROS1));
  }
}
