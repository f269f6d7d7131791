package org.robotui.lcm.type;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is read of {@code .lcm} files, and what is said of those that are wrong. */
class TypeParserTest {

  @Test
  void packagesConstantsAndArraysAreRead() throws TypeException {
    List<TypeDefinition> types = TypeParser.parse("grid.lcm", """
        // a file
        package maps /* of grids */ ;
        struct grid_t {
            const int8_t UNKNOWN = -1, FREE = 0, FULL = 0x64; // values
            const double PI = 3.14;
            int32_t height, width;
            int8_t cells[height][width], corners[2][FULL];
            geo.point_t origin;
            name_t name;
        }
        package geo; struct point_t { double x, y; };""");
    TypeDefinition.Struct grid = (TypeDefinition.Struct) types.getFirst();
    assertEquals("maps.grid_t", grid.name());
    assertEquals(List.of("int32_t height", "int32_t width", "int8_t cells[height][width]", "int8_t corners[2][0x64]",
        "geo.point_t origin", "maps.name_t name"), grid.members().stream().map(MemberDefinition::toString).toList());
    assertEquals(List.of(-1L, 0L, 100L, 3.14), grid.constants().stream().map(ConstantDefinition::value).toList());
    assertEquals("geo.point_t", types.get(1).name());
    assertEquals("grid.lcm:7:12", grid.members().get(2).place().toString());
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', textBlock = """
      struct a { double x[n]; }                | t.lcm:1:21: the array size 'n' is not declared before the array; declare it above: int32_t n;
      struct a { double n; int8_t x[n]; }      | t.lcm:1:31: the array size 'n' is no integer, but a double n
      struct a { int x; }                      | t.lcm:1:12: LCM has no type 'int'; take one of int8_t
      struct a { double x; float x; }          | t.lcm:1:28: the name 'x' is used twice
      struct a { double x[0]; }                | t.lcm:1:21: an array cannot have the size 0
      struct a { double x[]; }                 | t.lcm:1:21: an array needs a size
      struct a { double x[                     | t.lcm:1:21: an array needs a size
      struct a { double x                      | t.lcm:1:20: expected ';' and found the end of the file
      struct a { double 2x; }                  | t.lcm:1:19: expected a name and found '2x'
      struct a { const string S = hello; }     | t.lcm:1:18: a constant cannot be of type 'string'
      struct a { const int8_t S = 200; }       | t.lcm:1:29: '200' is no int8_t
      struct a { const float S = 1e39; }       | t.lcm:1:28: '1e39' is no float
      struct a { struct b { int8_t x; } y; }   | t.lcm:1:12: a type cannot be declared inside another
      enum a { B = 1, C = 1 }                  | t.lcm:1:17: the name 'C' or the value 1 is used twice
      class a { }                              | t.lcm:1:1: expected 'package', 'struct' or 'enum' and found 'class'
      struct a { /* forgotten }                | t.lcm:1:12: this comment has no end; write */ where it ends
      package 1x;                              | t.lcm:1:9: expected the name of a package
      """)
  void whatIsWrongIsSaidWithItsPlaceAndARemedy(String text, String error) {
    TypeException e = assertThrows(TypeException.class, () -> TypeParser.parse("t.lcm", text));
    assertTrue(e.getMessage().startsWith(error), e.getMessage());
    assertTrue(e.getMessage().contains("; "), e.getMessage());
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', textBlock = """
      struct a { b c; } struct d { int8_t x; }                          | d | 1:14: the type 'b' is not known
      struct a { a self; }  struct d { int8_t x; }                      | d | 1:14: 'a self' holds itself
      struct a { b c[2]; } struct b { a c; } struct d { int8_t x; }     | d | holds itself
      struct d { int8_t x; } struct d { int16_t x; }                    | d | 1:31: the type 'd' is declared otherwise at t.lcm:1:8
      """)
  void whatIsBrokenLeavesTheRestUsable(String text, String usable, String error) throws TypeException {
    TypeLibrary library = TypeLibrary.of(TypeParser.parse("t.lcm", text), List.of());
    assertTrue(library.problems().getFirst().getMessage().contains(error), library.problems().toString());
    assertEquals(List.of(usable), library.types().stream().map(LcmType::name).toList());
  }

  @Test
  void typesMayHoldEachOtherInArraysThatMayBeEmpty() throws TypeException {
    String text = "struct a { b part; } struct b { int32_t n; a parts[n]; }";
    assertEquals(List.of(), TypeLibrary.of(TypeParser.parse("t.lcm", text), List.of()).problems());
  }

  @Test
  void foldersAreReadAtAnyDepthAndBrokenFilesAreNamed(@TempDir Path folder) throws IOException {
    Files.createDirectories(folder.resolve("deep/deeper"));
    Files.writeString(folder.resolve("deep/deeper/good_t.lcm"), "struct good_t { double x; }");
    Files.writeString(folder.resolve("bad_t.lcm"), "struct bad_t {\n  doubel[2] x; }");
    Files.write(folder.resolve("binary.lcm"), new byte[]{-1, -2, 0});
    Files.writeString(folder.resolve("readme.txt"), "no types");
    TypeLibrary library = TypeFolder.read(List.of(folder));
    assertEquals(List.of("good_t"), library.types().stream().map(LcmType::name).toList());
    assertEquals(2, library.problems().size());
    assertTrue(library.problems().get(0).getMessage().contains("bad_t.lcm:2:9: "), library.problems().toString());
    assertTrue(library.problems().get(1).getMessage().contains("no UTF-8 text"), library.problems().toString());
    IOException missing = assertThrows(IOException.class, () -> TypeFolder.read(List.of(folder.resolve("none"))));
    assertTrue(missing.getMessage().contains("none"), missing.getMessage());
  }
}
