/**
 * A bundle whose view misbehaves on the display thread as its settings say. Tests pack it at run time and install it.
 */
package org.robotui.tests.badwindow;
