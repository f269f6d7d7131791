/**
 * A bundle that brings a type of data which nobody else knows, a robot that sends it, a layer of maps and a display of
 * scenes that show it, all in the same colour. Tests pack it at run time and install it.
 */
package org.robotui.tests.novelty;
