/** Questions to components, and looking at what a naming service knows. */
package org.robotui.rfic.smartsoft.internal.call;
